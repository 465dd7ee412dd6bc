"""The rules of the house, one function each: it is given a file and yields (line number, what is wrong)."""

import re
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Callable, Iterator

Finding = tuple[int, str]

MAX_LINES_OF_PROGRAM = 400
MAX_LINES_OF_TESTS = 500


@dataclass(frozen=True)
class SourceFile:
    """A file of the project; its path is relative to the root of the repository."""

    path: str
    text: str

    @property
    def parts(self) -> tuple[str, ...]:
        return PurePosixPath(self.path).parts

    @property
    def name(self) -> str:
        return self.parts[-1]

    @property
    def is_cpp(self) -> bool:
        return self.path.endswith((".cpp", ".hpp"))

    @property
    def lines(self) -> list[str]:
        return self.text.splitlines()

    @property
    def code_lines(self) -> list[str]:
        """The lines without the insides of string literals and without comments of the // kind."""
        without_strings = (re.sub(r'"(\\.|[^"\\])*"', '""', line) for line in self.lines)
        return [line.split("//")[0] for line in without_strings]

    def is_in(self, *folders: str) -> bool:
        return any(self.path.startswith(folder + "/") for folder in folders)


@dataclass(frozen=True)
class Rule:
    name: str
    reason: str
    applies_to: Callable[[SourceFile], bool]
    find: Callable[[SourceFile], Iterator[Finding]]


def matches(lines: list[str], pattern: str) -> Iterator[Finding]:
    for number, line in enumerate(lines, start=1):
        if match := re.search(pattern, line):
            yield number, f"'{match.group(0).strip()}'"


def foreign_includes(file: SourceFile) -> Iterator[Finding]:
    own_folder = file.parts[1]
    for number, line in enumerate(file.lines, start=1):
        if match := re.match(r'\s*#\s*include\s*"([^"]*)"', line):
            if match.group(1).split("/")[0] not in ("core", own_folder) or ".." in match.group(1):
                yield number, f'includes "{match.group(1)}"'


def missing_pragma_once(file: SourceFile) -> Iterator[Finding]:
    if "#pragma once" not in file.lines:
        yield 1, "has no '#pragma once'"


def too_many_lines(file: SourceFile) -> Iterator[Finding]:
    limit = MAX_LINES_OF_TESTS if file.is_in("tests") else MAX_LINES_OF_PROGRAM
    if len(file.lines) > limit:
        yield limit + 1, f"has {len(file.lines)} lines, the limit is {limit}"


def implementation_defined_randomness(file: SourceFile) -> Iterator[Finding]:
    return matches(file.code_lines, r"\bstd::(\w+_distribution|random_device|shuffle|sample)\b|\brand\(\)")


def fast_math(file: SourceFile) -> Iterator[Finding]:
    return matches(file.lines, r"-ffast-math|-Ofast|-funsafe-math-optimizations|-fassociative-math")


def fixed_dimension(file: SourceFile) -> Iterator[Finding]:
    return matches(file.code_lines, r"\bVector[23]d\b")


def named_components(file: SourceFile) -> Iterator[Finding]:
    return matches(file.code_lines, r"(\.|->)[xy]\b")


def knows_the_dimension(file: SourceFile) -> bool:
    """Meshes, assemblies and regions are laid out along axes, edges have two ends, tensors have components by the
    names of axes, and so do case files."""
    return (
        file.path == "modules/core/vector.hpp"
        or file.is_in("modules/mesh", "modules/generation", "app/case", "app/build")
        or any(word in file.name for word in ("edge", "facet", "corner", "region", "tensor"))
    )


def postponed_work(file: SourceFile) -> Iterator[Finding]:
    return matches(file.lines, r"\b(TODO|FIXME|XXX|HACK)\b")


def is_rule_file(file: SourceFile) -> bool:
    return file.is_in("tests/architecture")


RULES = [
    Rule(
        "modules see core and themselves",
        "A module that includes a sibling, or the app, can no longer be exchanged or tested alone; core is below all.",
        lambda file: file.is_cpp and file.is_in("modules"),
        foreign_includes,
    ),
    Rule(
        "files stay small",
        "A file that has to be scrolled through holds more than one idea.",
        lambda file: file.is_cpp,
        too_many_lines,
    ),
    Rule(
        "headers are included once",
        "Without '#pragma once' a second include is a second definition.",
        lambda file: file.path.endswith(".hpp"),
        missing_pragma_once,
    ),
    Rule(
        "random numbers are the same everywhere",
        "Distributions and shuffles of the standard library differ between its implementations, and a random_device "
        "between runs: the same seed would make another assembly.",
        lambda file: file.is_cpp and file.is_in("modules"),
        implementation_defined_randomness,
    ),
    Rule(
        "roundings are the same everywhere",
        "Fast-math lets the compiler reorder sums, and a resumed run would not go on to the same bits.",
        lambda file: not is_rule_file(file),
        fast_math,
    ),
    Rule(
        "the dimension is not in the types",
        "Three dimensions are to come by changing core/vector.hpp, not every file.",
        lambda file: file.is_cpp and file.is_in("modules", "app"),
        fixed_dimension,
    ),
    Rule(
        "components are named where the dimension is known",
        "Elsewhere vectors are added, scaled and projected as a whole, so that a third component needs no change.",
        lambda file: file.is_cpp and file.is_in("modules", "app") and not knows_the_dimension(file),
        named_components,
    ),
    Rule(
        "no work is postponed in comments",
        "What is missing belongs where it is tracked, or is done now.",
        lambda file: not is_rule_file(file),
        postponed_work,
    ),
]
