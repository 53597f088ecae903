#!/usr/bin/env python3
"""house.py: how large host_tools is, and how much of it a reader has to walk through. Prints figures; never fails.

A function changes an argument if it takes one by reference or pointer that is not const; streams, which are made to be
changed, do not count. A climb is a step of the way of a recording through `diagnose`, as host_tools/README.md tells it,
into a folder that stands above the one before in the order of the data.
"""
import glob
import os
import re

os.chdir(os.path.join(os.path.dirname(__file__), "..", "..", "host_tools"))
KINDS = (".cpp", ".hpp", ".js", ".mjs", ".css", ".html")
SHORT = 40


def files_of(kinds):
    return sorted(f for f in glob.glob("**/*", recursive=True) if f.endswith(kinds) and os.path.isfile(f))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def parameter_lists(text):
    """Of function definitions, constructors and lambdas left out: name, parameters."""
    text = re.sub(r"//[^\n]*", "", text)
    head = r"^(?:[\w:<>,&*\[\]\s]+?[\s&*])([\w:~]+)\(((?:[^()]|\([^()]*\))*)\)(?: const)?(?: noexcept)?(?: override)? \{"
    for found in re.finditer(head, text, re.M):
        if found[1] not in ("if", "for", "while", "switch", "catch", "return"):
            yield found[1], found[2]


def changes_argument(parameters):
    for parameter in re.split(r",(?![^<(]*[>)])", parameters):
        kind = parameter.split("=")[0]
        if re.search(r"[&*]", kind) and "const " not in kind and "&&" not in kind and "stream" not in kind:
            if not re.search(r"std::function<|Eigen::Ref<const", kind):
                return True
    return False


def share_that_changes(folder):
    functions = changing = 0
    for path in files_of((".cpp", ".hpp")):
        if not path.startswith(folder + "/"):
            continue
        for _, parameters in parameter_lists(read(path)):
            functions += 1
            changing += changes_argument(parameters)
    return functions, changing


def walk():
    """Files that the README's way names, in order, each by its folder."""
    readme = read("README.md")
    folders = re.findall(r"^\| \[(\w+)\]\(", readme, re.M)
    way = readme.split("## The way of a recording")[1].split("\n## ")[0]
    folder, files = "", []
    for name in re.findall(r"`([\w/]+\.(?:cpp|hpp))`", way):
        if "/" in name:
            folder = name.split("/")[0]
        files.append((folder, os.path.basename(name)))
    order = [folders.index(f) for f, _ in files if f in folders]
    return len(set(files)), sum(after < before for before, after in zip(order, order[1:]))


def main():
    files = files_of(KINDS)
    lengths = {path: read(path).count("\n") for path in files}
    print(f"{'lines of C++, JavaScript, CSS, HTML':44}{sum(lengths.values()):8}")
    print(f"{'files · under ' + str(SHORT) + ' lines':44}{len(files):8}{sum(n < SHORT for n in lengths.values()):8}")
    print(f"{'way through diagnose: files · climbs':44}{walk()[0]:8}{walk()[1]:8}")
    print(f"\n{'folder':20}{'lines':>8}{'files':>8}{'functions':>11}{'change an argument':>20}")
    for folder in sorted({path.split("/")[0] for path in files}):
        own = [path for path in files if path.startswith(folder + "/")]
        functions, changing = share_that_changes(folder)
        share = f"{100 * changing / functions:.0f} %" if functions else "-"
        print(f"{folder:20}{sum(lengths[p] for p in own):8}{len(own):8}{functions:11}{share:>20}")


main()
