# The headers comment members and constants behind them, in plain comments; Doxygen wants those marked.
/^ *(\/\*|#)/!s/([;,]|= -?[0-9]+) *\/\* /\1 \/**< /
# The title of a group ends where its members begin.
s/(@defgroup .*[^ ]) +@\{ \*\//\1\n *  @{ *\//
