# SPDX-License-Identifier: GPL-3.0-or-later
"""Docstrings: every Examples block runs, and every parameter is described."""

from __future__ import annotations

import doctest
import inspect
import re

import pytest

import teleta

NAMES = [name for name in teleta.__all__ if name != "__version__"]


def documented():
    """Yield the public functions and methods by their name."""
    for module in (teleta, teleta.study):
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isclass(value) and not issubclass(value, BaseException):
                yield f"{name}", value
                for part, member in vars(value).items():
                    if not part.startswith("_") and (inspect.isfunction(member) or isinstance(member, staticmethod)):
                        yield f"{name}.{part}", getattr(value, part)
            elif inspect.isfunction(value):
                yield name, value


DOCUMENTED = dict(documented())


@pytest.mark.parametrize("name", DOCUMENTED)
def test_the_examples_run(name):
    value = DOCUMENTED[name]
    names = {each: getattr(teleta, each) for each in NAMES}
    names.update({each: getattr(teleta.study, each) for each in teleta.study.__all__})
    finder = doctest.DocTestFinder(recurse=False)
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    for test in finder.find(value, name, globs=dict(names)):
        runner.run(test)
    assert runner.summarize(verbose=False).failed == 0


@pytest.mark.parametrize("name", [name for name, value in DOCUMENTED.items() if not inspect.isclass(value)])
def test_each_parameter_and_section_is_there(name):
    value = DOCUMENTED[name]
    text = inspect.getdoc(value) or ""
    parameters = [each for each in inspect.signature(value).parameters if each != "self"]
    if parameters:
        described = text.split("Parameters\n----------\n", 1)
        assert len(described) == 2, "no section Parameters"
        section = re.split(r"\n\w+\n-+\n", described[1])[0]
        listed = set()
        for line in re.findall(r"^(\w[\w, ]*)(?: :.*)?$", section, flags=re.MULTILINE):
            listed.update(part.strip() for part in line.split(","))
        assert set(parameters) <= listed, set(parameters) - listed
    if inspect.signature(value).return_annotation not in ("None", None):
        assert re.search(r"^(Returns|Yields)\n-+$", text, flags=re.MULTILINE) or text.startswith("Return ")


def test_most_functions_have_an_example():
    without = [
        name
        for name, value in DOCUMENTED.items()
        if inspect.isfunction(value) and "." not in name and ">>>" not in (value.__doc__ or "")
    ]
    assert without == ["open", "track"]
