# SPDX-License-Identifier: GPL-3.0-or-later
#
# The command line: what is refused before any work is done, and what the help says.
import os

from support import *


class Usage(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("in.poly", square)

    def refuse(self, *arguments, says, expect=USAGE):
        run = self.run_program(*arguments, expect=expect)
        self.assertEqual(run.out, "")
        self.assertIn(says, run.err)
        self.assertEqual(os.listdir(self.folder), ["in.poly"])

    def test_no_command_gives_the_help_and_fails(self):
        self.refuse(says="Usage: delref COMMAND")

    def test_an_unknown_command_is_told_with_those_known(self):
        self.refuse("weave", says="mesh, verify and info")

    def test_an_unknown_option_is_named(self):
        self.refuse("mesh", "in.poly", "-o", "a.vtu", "--fine", says="--fine")
        self.refuse("--fine", says="--fine")

    def test_missing_arguments_are_named(self):
        self.refuse("mesh", says="IN is missing")
        self.refuse("mesh", "in.poly", says="-o is missing")
        self.refuse("mesh", "in.poly", "-o", says="needs a value")
        self.refuse("verify", "in.poly", says="MESH is missing")
        self.refuse("info", says="MESH is missing")

    def test_a_value_that_makes_no_sense_is_refused(self):
        for option, values in {
            "--min-angle": ["60", "75", "-1", "nan", "x", ""], "--max-area": ["0", "-1", "nan", "inf", "x"],
            "--max-edge": ["0", "-2"], "--encroachment": ["square"], "--points": ["centre"], "--merge-tolerance": ["-1", "nan"],
            "--max-vertices": ["0", "-3", "1.5", "x"], "--time-limit": ["-1", "x"], "--smallest-edge": ["-1"],
            "--svg-colour": ["red"], "--radius-edge": ["0.99", "0", "-2", "nan", "inf", "x"], "--max-volume": ["0", "-1", "nan"],
            "--cell-size": ["0", "-1", "x"], "--join-coplanar": ["-1", "46", "nan"], "--planarity-tolerance": ["-1", "0.2", "x"],
            "--facet-angle": ["60", "-1", "nan"], "--facet-size": ["0", "-1", "inf", "x"], "--facet-distance": ["0", "nan"],
            "--iso": ["nan", "inf", "x", ""], "--inside": ["left"], "--background": ["x", "1.5"], "--smooth-labels": ["0", "4", "-1", "x"],
            "--sampling": ["0", "-1", "x"], "--region-cell-size": ["1", "x=1", "1=0", "1=", "=1"], "--smallest-facet": ["-1", "x"],
            "--neighbours": ["5", "7.5", "x"], "--outliers": ["0", "-1"], "--smooth-points": ["-1", "1.5"],
        }.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    self.refuse("mesh", "in.poly", "-o", "a.vtu", option + "=" + value, says=option)

    def test_an_option_given_twice_is_refused(self):
        self.refuse("mesh", "in.poly", "-o", "a.vtu", "--min-angle", "20", "--min-angle", "30", says="more than once")

    def test_a_gradation_without_points_is_refused(self):
        self.refuse("mesh", "in.poly", "-o", "a.vtu", "--gradation", "0.2", says="--size-points")

    def test_an_output_of_unknown_format_is_refused_with_those_known(self):
        self.refuse("mesh", "in.poly", "-o", "a.stl", says=".vtu")
        self.refuse("mesh", "in.poly", "-o", "a.vtu", "-o", "a", says=".vtu")

    def test_an_output_over_the_input_is_refused(self):
        self.refuse("mesh", "in.poly", "-o", "in.node", says="in.poly")
        self.refuse("mesh", "in.poly", "-o", "a.vtu", "--report", "./in.poly", says="in.poly")

    def test_two_outputs_of_one_name_are_refused(self):
        self.refuse("mesh", "in.poly", "-o", "a.vtu", "-o", "./a.vtu", says="a.vtu")
        self.refuse("mesh", "in.poly", "-o", "a.vtu", "--report", "a.vtu", says="a.vtu")

    def test_an_output_in_no_folder_is_told_before_meshing(self):
        self.refuse("mesh", "in.poly", "-o", "nowhere/a.vtu", says="nowhere", expect=INTERNAL)
        self.refuse("mesh", "in.poly", "-o", "a.vtu", "--report", "nowhere/a.json", says="nowhere", expect=INTERNAL)

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_an_output_in_a_folder_that_may_not_be_written_is_told(self):
        os.mkdir(self.path("shut"), 0o500)
        run = self.run_program("mesh", "in.poly", "-o", "shut/a.vtu", expect=INTERNAL)
        self.assertIn("shut/a.vtu", run.err)

    def test_an_output_that_is_a_folder_is_told(self):
        os.mkdir(self.path("a.vtu"))
        self.assertIn("directory", self.run_program("mesh", "in.poly", "-o", "a.vtu", expect=INTERNAL).err)

    def test_a_report_excludes_criteria(self):
        self.refuse("verify", "in.poly", "a.vtu", "--report", "a.json", "--min-angle", "20", says="--report")


class Help(ProgramTest):
    smooth = ["--implicit", "--bounds", "--iso", "--inside", "--closed", "--labels", "--background", "--smooth-labels", "--point-set",
              "--sampling", "--neighbours", "--outliers", "--smooth-points", "--facet-angle", "--facet-size", "--facet-distance",
              "--surface-only", "--region-cell-size", "--smallest-facet"]
    options = {
        "mesh": ["-o", "--min-angle", "--max-area", "--max-edge", "--size-points", "--gradation", "--encroachment", "--points",
                 "--split-crossings", "--keep-boundary", "--merge-tolerance", "--max-vertices", "--time-limit", "--smallest-edge",
                 "--strict", "--report", "--svg-colour", "--quiet", "--help", "--radius-edge", "--max-volume", "--cell-size",
                 "--join-coplanar", "--planarity-tolerance", "--regions", *smooth],
        "verify": ["--report", "--min-angle", "--max-area", "--max-edge", "--size-points", "--gradation", "--encroachment",
                   "--keep-boundary", "--split-crossings", "--merge-tolerance", "--help", "--radius-edge", "--max-volume",
                   "--cell-size", "--join-coplanar", "--planarity-tolerance", *smooth],
        "info": ["--help"],
    }

    def test_the_help_of_each_command_has_each_of_its_options_and_an_example(self):
        for command, options in self.options.items():
            for flag in ("--help", "-h"):
                text = self.run_program(command, flag).out
                self.assertIn(f"Usage: delref {command} ", text)
                self.assertRegex(text, "Examples?\n")
                self.assertIn("Exit codes", text)
                for option in options:
                    self.assertRegex(text, rf"(?m)^ +(-., )?{option}[ ,]")

    def test_the_help_of_a_command_has_no_option_that_the_command_does_not_know(self):
        for command, options in self.options.items():
            told = set(re.findall(r"(?m)^ +(?:-., )?(--[a-z-]+)", self.run_program(command, "--help").out))
            self.assertLessEqual(told - {"--output"}, set(options))

    def test_help_fits_into_100_columns(self):
        for arguments in (["--help"], *([command, "--help"] for command in self.options)):
            for line in self.run_program(*arguments).out.splitlines():
                self.assertLessEqual(len(line), 100, line)

    def test_the_help_of_the_program_names_the_commands_and_the_exit_codes(self):
        text = self.run_program("--help").out
        for word in ["mesh ", "verify ", "info ", *(f"\n  {code}  " for code in range(7))]:
            self.assertIn(word, text)

    def test_the_version_is_a_name_and_a_number(self):
        self.assertRegex(self.run_program("--version").out, r"^delref \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    main()
