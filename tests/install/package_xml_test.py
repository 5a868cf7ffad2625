#!/usr/bin/env python3
"""package.xml has the version of the project, and a key of rosdep for every package of tools/packages that has one.

usage: package_xml_test.py SOURCE_DIR VERSION
"""

import pathlib
import re
import sys
import xml.etree.ElementTree

# Keys of rosdep whose Debian packages have other names.
KEYS = {
    "libeigen3-dev": "eigen", "libbullet-dev": "bullet", "libassimp-dev": "assimp-dev", "libsdformat-dev": "sdformat",
    "libyaml-cpp-dev": "yaml-cpp", "libcli11-dev": "cli11", "nlohmann-json3-dev": "nlohmann-json-dev", "libfmt-dev": "fmt",
    "libjpeg-dev": "libjpeg", "zlib1g-dev": "zlib", "cyclonedds-dev": "cyclonedds"}
WITHOUT_KEY = {"g++", "libegl1", "libgl1-mesa-dri", "liblzf-dev", "musl-dev"}
NOT_IN_PACKAGES = {"tinyxml"}  # Debian's liburdfdom-dev brings it.


def main():
    source, version = pathlib.Path(sys.argv[1]), sys.argv[2]
    package = xml.etree.ElementTree.parse(source / "package.xml").getroot()
    sections = re.split(r"^\[(\w+)\]$", (source / "tools/packages").read_text(), flags=re.M)
    listed = dict(zip(sections[1::2], (text.split() for text in sections[2::2])))
    wanted = {KEYS.get(name, name) for name in [*listed["build"], *listed["web"]] if name not in WITHOUT_KEY} | NOT_IN_PACKAGES
    stated = {element.text for element in package if element.tag.endswith("depend")}
    if package.findtext("version") != version:
        sys.exit(f"package.xml has version {package.findtext('version')}, the project {version}")
    if stated != wanted:
        sys.exit(f"package.xml lacks {sorted(wanted - stated)}, and has {sorted(stated - wanted)} more than tools/packages")
    page = (source / "docs/ros2.md").read_text()
    for name in sorted(WITHOUT_KEY - {"g++"}):
        if not re.search(rf"apt-get install.*\b{name}\b", page):
            sys.exit(f"docs/ros2.md does not say how to install {name}, for which rosdep has no key")


if __name__ == "__main__":
    main()
