"""wheel_licence.py TREE: writes the licences of all that an unpacked wheel carries, one for each Debian package that has a file in
dist-info/licenses, into its metadata, and refuses anything under the GPL in the wheel `roughcontact`."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "scripts"))
from bill_of_materials import licence  # noqa: E402


def main() -> None:
    (folder,) = pathlib.Path(sys.argv[1]).glob("*.dist-info")
    metadata = folder / "METADATA"
    text = metadata.read_text(encoding="utf-8")
    own = re.search(r"^License-Expression: (.*)$", text, re.M)
    assert own, f"{metadata} has no License-Expression"
    if own[1] == "GPL-3.0-or-later":  # all that is inside is under it as a whole
        return
    packages = [file.name for file in (folder / "licenses").iterdir() if file.name.startswith(("lib", "zlib", "nlohmann"))]
    names = {name for package in packages for name in licence(package).split(" AND ")} | set(own[1].split(" AND "))
    under_gpl = [package for package in packages if "GPL" in licence(package)]
    if under_gpl:
        sys.exit(f"wheel_licence.py: {folder.name} must be free of the GPL, but carries {', '.join(under_gpl)}")
    metadata.write_text(text.replace(own[0], f"License-Expression: {' AND '.join(sorted(names))}", 1), encoding="utf-8")


main()
