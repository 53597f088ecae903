#!/usr/bin/env bash
# documents.sh ROOT: every relative link of every Markdown page leads to a file, every #anchor to a heading; lines
# have at most 120 columns, but for tables; every deciding number of a diagnosis stands in DIAGNOSIS.md by its name,
# and no other; CITATION.cff has the version of the build.
set -euo pipefail
exec python3 - "${1:?usage: documents.sh ROOT}" <<'EOF'
import os, re, sys, unicodedata

root = os.path.abspath(sys.argv[1])
problems = []


def pages():
    for folder, folders, files in os.walk(root):
        folders[:] = [f for f in folders if not f.startswith((".", "build")) and f != "node_modules"]
        yield from (os.path.join(folder, f) for f in files if f.endswith(".md"))


def lines_of(page):
    """Lines with their numbers, and whether they are code in a fence."""
    fenced = False
    with open(page, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            fence = line.lstrip().startswith("```")
            yield number, line.rstrip("\n"), fenced or fence
            fenced ^= fence


def anchors(page):
    """Of its headings, as GitHub makes them."""
    found = set()
    for _, line, code in lines_of(page):
        if code or not re.match(r"#{1,6} ", line):
            continue
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", line.lstrip("#").strip()).lower()
        kept = (c for c in text if c in " -_" or unicodedata.category(c)[0] in "LN")
        base = anchor = "".join(kept).replace(" ", "-")
        count = 0
        while anchor in found:
            count += 1
            anchor = f"{base}-{count}"
        found.add(anchor)
    return found


def check_link(page, number, target):
    if re.match(r"[a-z]+:", target):
        return
    path, _, anchor = target.partition("#")
    file = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
    if not os.path.exists(file):
        problems.append(f"{page}:{number}: {target} is not there")
    elif anchor and anchor not in anchors(file):
        problems.append(f"{page}:{number}: {target}: no such heading")


def check_page(page):
    for number, line, code in lines_of(page):
        if len(line) > 120 and not line.lstrip().startswith("|"):
            problems.append(f"{page}:{number}: {len(line)} columns")
        if code or line.startswith("    "):
            continue
        for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
            check_link(page, number, target)


def check_rules():
    rules = os.path.join(root, "host_tools/diagnosis/decision_rules.hpp")
    page = os.path.join(root, "host_tools/DIAGNOSIS.md")
    if not os.path.exists(page):
        return
    with open(rules, encoding="utf-8") as file:
        names = set(re.findall(r"^(?:constexpr|inline const) .*?\b(k[A-Z]\w*)\b", file.read(), re.M))
    with open(page, encoding="utf-8") as file:
        text = file.read()
    problems.extend(f"{page}: {name} of {rules} is not in it" for name in names if f"`{name}`" not in text)
    # Other numbers stand with the file that has them.
    for name in set(re.findall(r"`(k[A-Z]\w*)`", text)) - names:
        files = re.findall(rf"`{name}`[^`)]*`([a-z_/]+\.[ch]pp)`", text)
        places = [os.path.join(root, "host_tools", "" if "/" in f else "diagnosis", f) for f in files]
        if not any(name in open(place, encoding="utf-8").read() for place in places):
            problems.append(f"{page}: {name} is no rule, and no file is named that has it")


def check_version():
    citation = os.path.join(root, "CITATION.cff")
    if not os.path.exists(citation):
        return
    with open(citation, encoding="utf-8") as file:
        cited = re.search(r"^version: (\S+)", file.read(), re.M)[1]
    with open(os.path.join(root, "CMakeLists.txt"), encoding="utf-8") as file:
        built = re.search(r"^\s*VERSION (\d\S+)", file.read(), re.M)[1]
    if cited != built:
        problems.append(f"{citation}: version {cited}, the build has {built}")


count = 0
for page in sorted(pages()):
    check_page(page)
    count += 1
check_rules()
check_version()
print("\n".join(problem.replace(root + "/", "") for problem in problems), file=sys.stderr, end="\n" if problems else "")
if not problems:
    print(f"{count} pages: links, headings, columns, names of rules")
sys.exit(bool(problems))
EOF
