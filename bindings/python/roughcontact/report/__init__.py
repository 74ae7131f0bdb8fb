"""One page about a surface under load: python -m roughcontact report FILE ... --out report.html

The page holds all it shows: it opens without a network and can be handed on. It is made with Jinja2 and Plotly
(pip install 'roughcontact[report]'), which are imported when a page is written.
"""
