"""Checks the files of the project against the rules of rules.py; prints what breaks them and fails if anything does.

Usage: check.py ROOT_OF_THE_REPOSITORY
"""

import sys
from pathlib import Path
from typing import Iterator

from rules import RULES, SourceFile

FOLDERS = ("modules", "app", "tests", "cmake", "scripts", "config")
TOP_LEVEL = ("CMakeLists.txt", "CMakePresets.json")
SUFFIXES = (".cpp", ".hpp", ".py", ".cmake", ".txt", ".json", ".toml", "")


def source_files(root: Path) -> Iterator[SourceFile]:
    paths = [root / name for name in TOP_LEVEL]
    for folder in FOLDERS:
        paths += sorted(path for path in (root / folder).rglob("*") if path.is_file() and path.suffix in SUFFIXES)
    for path in paths:
        yield SourceFile(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8"))


def main() -> int:
    files = list(source_files(Path(sys.argv[1])))
    n_findings = 0
    for rule in RULES:
        findings = [(file, *finding) for file in files if rule.applies_to(file) for finding in rule.find(file)]
        if findings:
            print(f"\nRule: {rule.name}. {rule.reason}")
        for file, line, what in findings:
            print(f"  {file.path}:{line}: {what}")
        n_findings += len(findings)
    print(f"{len(files)} files, {len(RULES)} rules, {n_findings} findings")
    return 1 if n_findings else 0


if __name__ == "__main__":
    sys.exit(main())
