"""What the docs call the program's: every --option on every page is one that a subcommand's --help has, every subcommand is there, and those of other programs are known by
name: options_test.py."""
import os
import pathlib
import re
import subprocess
import unittest

SOURCE = pathlib.Path(os.environ.get("ODONTOSCOPE_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
PROGRAM = os.environ.get("ODONTOSCOPE_PROGRAM", str(SOURCE / "build/release/engine/app/odontoscope"))

#: Options of other programs, by whose they are.
OF_OTHERS = {
    "cmake and ctest": {"--build", "--install", "--prefix", "--preset", "--target", "--test"},
    "GoogleTest": {"--gtest"},
    "./test and tests/": {"--changed", "--quick", "--large", "--xr", "--every-spacing", "--failing", "--labels", "--seed", "--seeds", "--tables", "--state"},
    "Python's venv": {"--system-site-packages"},
    "GNU parallel": {"--joblog"},
    "Chromium": {"--enable-unsafe-swiftshader", "--headless", "--no-pdf-header-footer", "--print-to-pdf", "--use-angle", "--virtual-time-budget"},
}


def help_of(*words):
    return subprocess.run([PROGRAM, *words, "--help"], text=True, capture_output=True, check=True).stdout


class Docs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        general = help_of()
        listed = re.search(r"^Subcommands:\n(.*?)\n\n", general, re.M | re.S).group(1)
        cls.subcommands = {name for line in re.findall(r"^  ([a-z][a-z, -]*[a-z])   ", listed, re.M) for name in line.split(", ")}
        cls.options = set(re.findall(r"--[a-z][a-z-]*", general))
        for name in cls.subcommands:
            cls.options |= set(re.findall(r"^  (?:-[a-z],)?(--[a-z][a-z-]*)", help_of(name), re.M))
        cls.pages = [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", *sorted((SOURCE / "docs").glob("*.md"))]

    def test_options_are_in_the_help(self):
        others = set().union(*OF_OTHERS.values())
        used = set()
        for page in self.pages:
            for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", page.read_text(encoding="utf-8")):
                used.add(option)
                self.assertTrue(option in self.options or option in others, f"{page.name}: {option} is in no --help")
        self.assertEqual(others - used, set(), "options of others that no page names")
        self.assertGreater(len(used & self.options), 60)

    def test_subcommands_are_in_the_help(self):
        for page in self.pages:
            for command in re.findall(r"^(?: {4}|\$ )?odontoscope (?:--(?:quiet|threads \S+) )*([a-z][a-z-]+)", page.read_text(encoding="utf-8"), re.M):
                self.assertIn(command, self.subcommands, f"{page.name}: odontoscope {command}")


if __name__ == "__main__":
    unittest.main()
