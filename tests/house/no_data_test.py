#!/usr/bin/env python3
"""No file of the repository is a database: data of people never get in by accident."""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(os.environ.get("PROMENADE_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
MAGIC = b"SQLite format 3\0"
IGNORED = ["a.db", "a.db-wal", "a.db-shm", "a.db.part", "a.db.v1.backup", "results/x/report.html",
           "walk.study", "results/a-1.db"]


def git(*arguments, root=ROOT):
    return subprocess.run(["git", *arguments], cwd=root, capture_output=True, check=False)


def tracked_databases(root):
    """Also under another name, and before they are committed."""
    names = git("ls-files", "-z", "--cached", "--others", "--exclude-standard", root=root).stdout
    for name in filter(None, names.split(b"\0")):
        path = root / os.fsdecode(name)
        if path.is_file():
            with path.open("rb") as file:
                if file.read(len(MAGIC)) == MAGIC:
                    yield os.fsdecode(name)


def finds_a_database():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        git("init", "-q", root=root)
        (root / "notes.txt").write_bytes(MAGIC + b"...")
        return list(tracked_databases(root)) == ["notes.txt"]


def main():
    if git("rev-parse", "--git-dir").returncode != 0:
        print("no git, or no checkout: nothing is tracked here")
        return 0
    found = [f"{name}: is a database; git rm --cached it" for name in tracked_databases(ROOT)]
    found += [f".gitignore does not cover {name}" for name in IGNORED
              if git("check-ignore", "-q", name).returncode != 0]
    if not finds_a_database():
        found.append("a database in a repository is not found")
    print("\n".join(found) if found else "no data are tracked")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
