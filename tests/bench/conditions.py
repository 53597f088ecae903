#!/usr/bin/env python3
"""conditions.py EXPORT FOLDER UNREACHABLE: the conditions of the decisions in FOLDER that tests have shown to decide by
themselves (MC/DC), from `llvm-cov export`. A condition that is a decision of its own is shown if it was true and false.
One instantiation of a template suffices.

Prints a table, a line for each folder, and each condition that is not shown. UNREACHABLE lists those that no test can
show: FILE | CONDITION as the source has it | why. Exits 1 if a condition is neither shown nor listed, if a listed one is
shown or is no condition, if a decision has conditions that the compiler has not analysed, or if no test compiles a
file that decides."""
import collections
import json
import os
import re
import sys

BRANCH, CONDITION = 4, 6  # kinds of region, llvm/ProfileData/Coverage/CoverageMapping.h


class Condition:
    def __init__(self):
        self.was_true = self.was_false = self.in_decision = self.shown = False


def read_conditions(export, folder):
    """{(file, (line, column), (end line, end column)): Condition}"""
    found = collections.defaultdict(Condition)
    with open(export, encoding="utf-8") as file:
        functions = json.load(file)["data"][0]["functions"]
    for function in functions:
        decisions = {tuple(record[:4]) for record in function["mcdc_records"]}
        own = set()
        for line, column, end, end_column, true, false, file_id, _, kind in function["branches"]:
            source = os.path.relpath(function["filenames"][file_id])
            if kind not in (BRANCH, CONDITION) or not source.startswith(folder + "/"):
                continue
            if kind == BRANCH and (line, column, end, end_column) in decisions:
                continue  # a whole decision, not a condition of it
            key = (source, (line, column), (end, end_column))
            condition = found[key]
            condition.was_true |= true > 0
            condition.was_false |= false > 0
            condition.in_decision |= kind == CONDITION
            if kind == CONDITION:
                own.add(key)
        for line, column, end, end_column, *_, shown in function["mcdc_records"]:
            inside = sorted(key for key in own if (line, column) <= key[1] and key[2] <= (end, end_column))
            if len(inside) < len(shown):  # a fold expression: the source has once what is there for each argument
                shown = [all(shown)] * len(inside)
            for key, is_shown in zip(inside, shown):
                found[key].shown |= is_shown
    for condition in found.values():
        if not condition.in_decision:
            condition.shown = condition.was_true and condition.was_false
    return found


def uncompiled(export, folder):
    """Files that decide something and are in no test."""
    with open(export, encoding="utf-8") as file:
        compiled = {os.path.relpath(name) for function in json.load(file)["data"][0]["functions"]
                    for name in function["filenames"]}
    for path, _, names in os.walk(folder):
        for source in (os.path.join(path, name) for name in names if name.endswith((".hpp", ".cpp"))):
            with open(source, encoding="utf-8") as file:
                code = re.sub("//.*|^#.*", "", file.read(), flags=re.MULTILINE)
            if source not in compiled and re.search(r"\b(if|for|while|case)\b|&&|\|\||\?", code):
                yield source


class Sources:
    def __init__(self):
        self.lines = {}

    def text(self, key):
        """The condition as the source has it, the text before and the text behind."""
        source, start, end = key
        if source not in self.lines:
            with open(source, encoding="utf-8") as file:
                self.lines[source] = file.read().split("\n")
        lines = self.lines[source]
        at = sum(len(line) + 1 for line in lines[:start[0] - 1]) + start[1] - 1
        to = sum(len(line) + 1 for line in lines[:end[0] - 1]) + end[1] - 1
        whole = "\n".join(lines)
        return re.sub(r"\s+", " ", whole[at:to]), whole[:at], whole[to:]


def is_operand(before, behind):
    return re.search(r"(&&|\|\|)[\s(!]*$", before) or re.match(r"[\s)]*(&&|\|\|)", behind)


def read_unreachable(path):
    listed = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                source, condition, reason = line.strip().split(" | ", 2)
                listed[source, condition] = reason
    return listed


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    export, folder, path = sys.argv[1:]
    found = read_conditions(export, folder)
    listed = read_unreachable(path)
    sources = Sources()
    table = collections.defaultdict(lambda: [0, 0, 0])
    failures = [f"in no test: {source}" for source in sorted(uncompiled(export, folder))]
    used = set()
    for key, condition in sorted(found.items()):
        text, before, behind = sources.text(key)
        if re.search(r"\bswitch \($", before):
            continue  # the branch to no case at all: -Wswitch asks for a case for each value
        name = os.path.relpath(key[0], folder)
        entry = (name, text)
        where = f"{key[0]}:{key[1][0]}:{key[1][1]}: {text}"
        row = table[os.path.dirname(name)]
        row[0] += 1
        row[1] += condition.shown
        if not condition.in_decision and is_operand(before, behind):
            failures.append(f"not analysed, because decisions are nested: {where}")
        elif condition.shown:
            if entry in listed:
                failures.append(f"listed as unreachable, but shown: {where}")
        elif entry in listed:
            used.add(entry)
            row[2] += 1
        else:
            seen = [word for word, was in (("true", condition.was_true), ("false", condition.was_false)) if was]
            failures.append(f"not shown, was {' and '.join(seen) or 'never evaluated'}: {where}")
    failures += [f"listed as unreachable, but no condition that is not shown: {' | '.join(entry)}"
                 for entry in sorted(set(listed) - used)]
    print(f"{'folder':14} conditions  shown  unreachable")
    for name, row in [*sorted(table.items()), ("all", [sum(column) for column in zip(*table.values())])]:
        print(f"{name:14} {row[0]:10} {row[1]:6} {row[2]:12}")
    for failure in failures:
        print(failure)
    sys.exit(1 if failures else 0)


main()
