#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""browser_page.py PROGRAM FOLDER FILE: puts the program, as CMake has built it in PROGRAM, into the two forms of the page: FOLDER
for a web server, and FILE, which contains everything and opens from disk."""

import base64
import gzip
import pathlib
import shutil
import sys

PACKAGE = pathlib.Path(__file__).parent
SCRIPTS = ("slidercrank.js", "qtloader.js")


def main():
    program, folder, file = map(pathlib.Path, sys.argv[1:])
    wasm = (program / "slidercrank.wasm").read_bytes()
    icon = base64.b64encode((PACKAGE.parent.parent / "resources/slidercrank.svg").read_bytes()).decode()
    page = (PACKAGE / "browser.html").read_text(encoding="utf-8")
    page = page.replace("@ICON@", icon).replace("@SIZE@", str(len(wasm)))

    folder.mkdir(parents=True)
    for name in (*SCRIPTS, "slidercrank.wasm"):
        shutil.copy(program / name, folder)
    links = "\n".join(f'<script src="{name}"></script>' for name in SCRIPTS)
    for name in ("slidercrank.html", "index.html"):  # a server shows the second one for the address of the folder
        (folder / name).write_text(page.replace("@PACKED@\n", "").replace("@SCRIPTS@", links), encoding="utf-8")

    packed = base64.b64encode(gzip.compress(wasm, 9, mtime=0)).decode()
    contents = []
    for name in SCRIPTS:
        # "</script" would end the element, also within a text.
        contents.append("<script>" + (program / name).read_text(encoding="utf-8").replace("</script", "<\\/script") + "</script>")
    single = page.replace("connect-src 'self'", "connect-src 'none'")
    single = single.replace("@PACKED@", f'<script type="application/octet-stream" id="packed">{packed}</script>')
    single = single.replace("@SCRIPTS@", "\n".join(contents))
    file.write_text(single, encoding="utf-8")


if __name__ == "__main__":
    main()
