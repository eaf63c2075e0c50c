#!/usr/bin/env python3
"""Holds the directions of dependencies that docs/architecture.md describes."""
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(os.environ.get("PROMENADE_SOURCE_DIR", pathlib.Path(__file__).parents[2]))

# What each room may include with quotes, and which libraries beyond the standard one.
ROOMS = {
    "motion": {"own": ("motion/",), "libraries": ("Eigen/",)},
    "study": {"own": ("motion/", "study/"),
              "libraries": ("Eigen/", "sqlite3.h", "fmt/", "nlohmann/", "toml++/", "sodium.h")},
    "analysis": {"own": ("motion/", "study/", "analysis/"),
                 "libraries": ("Eigen/", "sqlite3.h", "fmt/", "nlohmann/", "boost/")},
    "app": {"own": ("motion/", "study/", "analysis/", "app/"),
            "libraries": ("Eigen/", "fmt/", "nlohmann/", "CLI/", "GLFW/", "X11/", "imgui",
                          "backends/imgui_", "epoxy/")},
}
# CLI11 takes longer to compile than a command does: it stays behind app/command_line.h.
CLI11_FILES = ("app/command_line.cpp", "app/main.cpp", "app/usage_error.cpp", "app/usage_error.h")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:<([^>]+)>|"([^"]+)")')
STANDARD = re.compile(r"^[a-z_]+$|^[a-z_]+\.h$|^sys/[a-z_]+\.h$")
MONOTONIC = re.compile(r"steady_clock|high_resolution_clock|CLOCK_MONOTONIC|glfwGetTime\b")
WALL = re.compile(r"system_clock|CLOCK_REALTIME|\bgmtime|\blocaltime|std::time\(")


def problems_in(path, room):
    rules = ROOMS[room]
    relative = path.relative_to(ROOT)
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        place = f"{relative}:{number}"
        match = INCLUDE.match(line)
        if match:
            library, own = match.groups()
            if own and not own.startswith(rules["own"]):
                yield f"{place}: {room}/ may not include {own}"
            if library and not library.startswith(rules["libraries"]):
                if not STANDARD.match(library) or library.startswith(("imgui", "sqlite3", "sodium")):
                    yield f"{place}: {room}/ may not include <{library}>"
            if library and library.startswith("CLI/") and str(relative) not in CLI11_FILES:
                yield f"{place}: commands include app/command_line.h, not <{library}>"
        code = line.split("//")[0]
        if MONOTONIC.search(code) and not str(relative).startswith(("app/window/", "app/doctor/")):
            yield f"{place}: only app/window and app/doctor read a monotonic clock"
        if WALL.search(code) and str(relative) != "study/identity.cpp":
            yield f"{place}: only study/identity.cpp reads the wall clock"
        if path.suffix == ".h" and "using namespace" in code:
            yield f"{place}: a header imports a namespace"
    if path.suffix == ".h":
        if not lines or not lines[0].startswith("// "):
            yield f"{relative}:1: a header opens with what it is"
        if "#pragma once" not in lines:
            yield f"{relative}: #pragma once is missing"


def shared_folders():
    """ctest runs tests side by side: each takes its folder from tests/test_folder.h."""
    for path in sorted((ROOT / "tests").rglob("*.cpp")) + sorted((ROOT / "tests").rglob("*.h")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if "TempDir()" in line:
                yield f"{path.relative_to(ROOT)}:{number}: tests share this folder; use TestFolder"


def main():
    found = list(shared_folders())
    files = 0
    for room in ROOMS:
        for path in sorted((ROOT / room).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                files += 1
                found += problems_in(path, room)
    print("\n".join(found) if found else f"{files} files keep the directions")
    return 1 if found or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
