"""Every rule finds what breaks it, and lets pass what only looks like it."""

import unittest

from rules import RULES, SourceFile


def broken_rules(path: str, text: str) -> set[str]:
    file = SourceFile(path, text)
    return {rule.name for rule in RULES if rule.applies_to(file) and list(rule.find(file))}


class Modules(unittest.TestCase):
    NAME = "modules see core and themselves"

    def test_own_folder_core_and_libraries_are_allowed(self):
        text = '#include "contact/cell_grid.hpp"\n#include "core/state.hpp"\n#include <fmt/format.h>\n'
        self.assertEqual(broken_rules("modules/contact/search.cpp", text), set())

    def test_a_sibling_is_found(self):
        for text in ('#include "mesh/facet.hpp"\n', '#include "app/audit.hpp"\n', '  #  include "../io/csv.hpp"\n'):
            self.assertEqual(broken_rules("modules/contact/search.cpp", text), {self.NAME})

    def test_a_name_without_folder_is_found(self):
        self.assertEqual(broken_rules("modules/contact/search.cpp", '#include "search.hpp"\n'), {self.NAME})

    def test_a_way_around_through_core_is_found(self):
        text = '#include "core/../mesh/facet.hpp"\n'
        self.assertEqual(broken_rules("modules/contact/search.cpp", text), {self.NAME})

    def test_core_sees_core_alone(self):
        self.assertEqual(broken_rules("modules/core/state.cpp", '#include "io/csv.hpp"\n'), {self.NAME})

    def test_app_sees_everything(self):
        self.assertEqual(broken_rules("app/build.cpp", '#include "mesh/facet.hpp"\n#include "io/csv.hpp"\n'), set())


class Files(unittest.TestCase):
    def test_long_files_are_found(self):
        rule = {"files stay small"}
        for path, limit in (("modules/io/a.cpp", 400), ("app/a.cpp", 400), ("tests/io/a.cpp", 500)):
            self.assertEqual(broken_rules(path, "int a;\n" * limit), set())
            self.assertEqual(broken_rules(path, "int a;\n" * (limit + 1)), rule)

    def test_a_header_without_pragma_once_is_found(self):
        self.assertEqual(broken_rules("modules/io/a.hpp", "// text\n#pragma once\n"), set())
        self.assertEqual(broken_rules("app/a.hpp", "int a;\n"), {"headers are included once"})
        self.assertEqual(broken_rules("app/a.cpp", "int a;\n"), set())

    def test_postponed_work_is_found(self):
        rule = {"no work is postponed in comments"}
        self.assertEqual(broken_rules("app/a.cpp", "// TODO: later\n"), rule)
        self.assertEqual(broken_rules("tests/io/a.cpp", "int a;  // FIXME\n"), rule)


class Numbers(unittest.TestCase):
    def test_randomness_of_the_standard_library_is_found(self):
        rule = {"random numbers are the same everywhere"}
        for code in (
            "std::uniform_real_distribution<double> d;",
            "std::normal_distribution<> d;",
            "std::random_device seed;",
            "std::shuffle(a, b, g);",
            "int i = rand();",
        ):
            self.assertEqual(broken_rules("modules/generation/a.cpp", code), rule)
        self.assertEqual(broken_rules("modules/generation/a.cpp", "std::mt19937_64 g;  // no std::shuffle"), set())
        self.assertEqual(broken_rules("modules/generation/a.cpp", "double operand();"), set())
        self.assertEqual(broken_rules("app/run/run_id.cpp", "std::random_device seed;"), set())

    def test_fast_math_is_found_wherever_it_is_asked_for(self):
        rule = {"roundings are the same everywhere"}
        self.assertEqual(broken_rules("cmake/build_options.cmake", "add_compile_options(-ffast-math)"), rule)
        self.assertEqual(broken_rules("CMakePresets.json", '"CMAKE_CXX_FLAGS": "-Ofast"'), rule)


class Dimension(unittest.TestCase):
    NAME = "components are named where the dimension is known"

    def test_types_that_fix_the_dimension_are_found(self):
        rule = {"the dimension is not in the types"}
        self.assertEqual(broken_rules("modules/contact/a.cpp", "Eigen::Vector2d v;"), rule)

    def test_components_are_found(self):
        for code in ("f(v.x);", "v.y += 1.0;", "p->x = 2;", "a.force[i].y"):
            self.assertEqual(broken_rules("modules/contact/particle_contacts.cpp", code), {self.NAME})

    def test_what_only_looks_like_a_component_passes(self):
        for code in ("v.xi", "box.extent", 'f("a.x");', "a;  // of v.x", "y = x;"):
            self.assertEqual(broken_rules("modules/contact/particle_contacts.cpp", code), set())

    def test_some_files_know_the_dimension(self):
        for path in (
            "modules/core/vector.hpp",
            "modules/mesh/quadrilateral.cpp",
            "modules/generation/hexagonal.cpp",
            "modules/contact/edge_contacts.cpp",
            "app/build/build_model.cpp",
        ):
            self.assertNotIn(self.NAME, broken_rules(path, "v.x"))
        for path in ("modules/core/state.hpp", "app/simulation.cpp"):
            self.assertIn(self.NAME, broken_rules(path, "v.x"))


if __name__ == "__main__":
    unittest.main()
