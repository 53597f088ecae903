#!/usr/bin/env bash
# documents.sh ROOT: every relative link of every Markdown page leads to a file, every #anchor to a heading. Every file
# and folder of the tree that a page or a comment names is there, and every constant that a page names. Commands of pages
# name scripts, presets, targets, test labels, subcommands and options that exist. Tests that a page names exist, and each
# row of a table of promises names one. Lines have at most 120 columns, but
# for tables. Every deciding number of a diagnosis stands in DIAGNOSIS.md by its name, and no other. CITATION.cff has the
# version of the build.
set -euo pipefail
export PYTHONPATH PYTHONDONTWRITEBYTECODE=1
PYTHONPATH=$(realpath "$(dirname "$0")")
exec python3 - "${1:?usage: documents.sh ROOT}" <<'EOF'
import os, re, sys, unicodedata

from markdown import blocks

root = os.path.abspath(sys.argv[1])
problems = []


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


files = []  # of the tree, from ROOT
folders = set()
for folder, below, names in os.walk(root):
    below[:] = [f for f in below if not f.startswith((".", "build")) and f != "node_modules"]
    files += [os.path.relpath(os.path.join(folder, name), root) for name in names]
    folders |= {os.path.relpath(os.path.join(folder, name), root) for name in below}


def of_type(*endings):
    return sorted(os.path.join(root, file) for file in files if file.endswith(endings))


# A place may be named by the end of its path, and a program or a pair of files without what its name ends with.
places = files + [os.path.splitext(file)[0] for file in files] + sorted(folders)
ends = {place[at:] for place in places for at in [0] + [i + 1 for i, c in enumerate(place) if c == "/"]}
folder_names = {os.path.basename(folder) for folder in folders}
top_folders = {folder for folder in folders if "/" not in folder}
source_name = re.compile(r"(?<![*\w])(?:[\w-]+/)*[\w-]+\.(?:[ch]pp|sh|py|mjs|cmake|ld|md)\b")


def names_place(word):
    """Whether it can only be meant as one of the tree: no placeholder like boards/NAME, no file of a user."""
    if re.search(r"(?:^|/)[A-Z]{3,}(?:/|\.(?!md)|$)", word):
        return False
    return bool(source_name.fullmatch(word)) or (
        bool(re.fullmatch(r"[a-z_0-9]+(?:/[a-z_0-9]+)+/?", word)) and word.split("/")[0] in folder_names
        or bool(re.fullmatch(r"\w+(?:/[\w.-]+)+\.\w+", word)) and word.split("/")[0] in top_folders
    )


def check_place(page, number, word):
    if names_place(word) and word.rstrip("/") not in ends:
        problems.append(f"{page}:{number}: {word} is not there")


constants = set(re.findall(r"\bk[A-Z]\w+", " ".join(map(read, of_type("pp")))))


def check_constant(page, number, word):
    if re.fullmatch(r"k[A-Z]\w+", word) and word not in constants:
        problems.append(f"{page}:{number}: no source has {word}")


def check_comments():
    for path in of_type(".cpp", ".hpp", ".mjs", ".sh", ".cmake", "CMakeLists.txt"):
        comment = re.compile(r"//(.*)" if path.endswith(("pp", "mjs")) else r"^\s*#(.*)")
        for number, line in enumerate(read(path).splitlines(), 1):
            said = comment.search(line)
            for word in source_name.findall(said[1]) if said else []:
                check_place(path, number, word)


tests = set()  # Suite.Name, and Suite.* for each
for path in of_type("_test.cpp"):
    for suite, name in re.findall(r"^TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", read(path), re.M):
        tests |= {f"{suite}.{name}", f"{suite}.*"}


def check_test(page, number, word):
    if re.fullmatch(r"[A-Z]\w*[a-z]\w*\.(?:[A-Z]\w+|\*)", word) and word not in tests:
        problems.append(f"{page}:{number}: no test is {word}")


def check_promises(page):
    """Rows of tables of promises name a test: its promise's keeper."""
    in_table = False
    for number, line in enumerate(read(page).splitlines(), 1):
        if line.startswith("| promise | test |"):
            in_table = True
        elif not line.startswith("|"):
            in_table = False
        elif in_table and not line.startswith("|--"):
            named = re.findall(r"`([^`]+)`", line.split(" | ")[1])
            if not any(word in tests or word.endswith(".sh") for word in named):
                problems.append(f"{page}:{number}: no test keeps this promise")


# What commands may name: presets and targets, labels of tests and what their names are made of, subcommands.
words_of_builds = set(re.findall(r"[\w-]+", " ".join(map(read, of_type("CMakeLists.txt", ".cmake", "Presets.json")))))
words_of_tests = set(re.findall(r"\w+", " ".join(map(read, of_type("CMakeLists.txt", "_test.cpp")))))
labels = re.findall(r"fog_test\(\S+ (\w+)|fog_gtest\(\S+ \S+ (\w+)", " ".join(map(read, of_type("CMakeLists.txt"))))
labels = {one for pair in labels for one in pair if one}


def options_of_commands():
    """The options of each subcommand. A test holds the file to the tool: tests/integration/reference_document.sh."""
    path = os.path.join(root, "tests/checks/command_options.txt")
    lines = [line.split() for line in read(path).splitlines()] if os.path.exists(path) else []
    return {name.rstrip(":"): {"--help", *options} for name, *options in lines}


command_options = options_of_commands()
all_options = set().union(*command_options.values())
sources = {}  # of a script or program, by its name without an ending
for path in of_type(".sh", ".py", ".mjs", ".cpp"):
    sources.setdefault(os.path.splitext(os.path.basename(path))[0], []).append(path)


def has_option(program, option):
    """Also one that a script hands on to fogcomp."""
    text = "".join(map(read, sources[program]))
    return bool(re.search(rf"{option}\b", text)) or (option in all_options and "fogcomp" in text and '"$@"' in text)


def program_of(word):
    return os.path.splitext(os.path.basename(word))[0] if "/" in word or word.endswith(".sh") else ""


def wrong_options(text, programs):
    """Options in TEXT that its command or its program of the tree lacks; of a text without either, those that all
    commands and PROGRAMS lack. Programs of others are not judged."""
    wrong = []
    for part in text.split(" | "):
        words = part.split()
        options = [word[0] for word in map(re.compile(r"--[a-z][a-z0-9-]*").findall, words) if word]
        if not options or not words:
            continue
        first = words[0].strip("[")
        program = program_of(first)
        if "fogcomp" in (first, program):
            words = words[1:]
            first = words[0] if words else ""
            if first not in command_options:
                continue
        if first in command_options:
            wrong += [f"{first} has no option {o}" for o in options if o not in command_options[first]]
        elif first.startswith("--"):
            unknown = [o for o in options if o not in all_options and not any(has_option(p, o) for p in programs)]
            wrong += [f"nothing that the page names has an option {o}" for o in unknown]
        elif program in sources:
            wrong += [f"{first} has no option {o}" for o in options if not has_option(program, o)]
    return wrong


def check_command(page, number, text, programs):
    """TEXT: of a back-ticked span or a line of code, on a page that names PROGRAMS of the tree."""
    wrong = []
    for script in re.findall(r"(?:^|[\s;&])((?:[\w.-]+/)+[\w-]+\.sh)\b", text):
        if script in files and not os.access(os.path.join(root, script), os.X_OK):
            wrong.append(f"{script} cannot be run")
    if re.match(r"cmake\b", text):
        named = re.findall(r"--(?:preset|target)[ =]([a-z]\w*)", text)
        wrong += [f"no preset or target {name}" for name in named if name not in words_of_builds]
    if re.match(r"ctest\b", text):
        wrong += [f"no tests have the label {name}" for name in re.findall(r" -L (\w+)", text) if name not in labels]
        for name in re.findall(r" -R (\S+)", text):
            if name in labels or not set(re.findall(r"\w+", name)) <= words_of_tests:
                wrong.append(f"no test has {name} in its name")
    for name in re.findall(r"tests/run\.sh ([a-z_.*' ]+)", text) if "tests/run.sh " in text else []:
        for one in name.replace("'", "").split():
            if one not in labels and not set(re.findall(r"\w+", one)) <= words_of_tests:
                wrong.append(f"no test and no kind of test: {one}")
    if command_options:
        for called in re.findall(r"(?:^|[\s;&|(])fogcomp ([a-z]+)(?= |$)", text):
            if called not in {*command_options, "help"}:
                wrong.append(f"fogcomp has no command {called}")
        wrong += wrong_options(text.removeprefix("… "), programs)
    problems.extend(f"{page}:{number}: {text.strip()}: {what}" for what in wrong)


def anchors(page):
    """Of its headings, as GitHub makes them."""
    found = set()
    for block in blocks(page):
        if block.kind != "heading":
            continue
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", block.text.lstrip("#").strip()).lower()
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
    check_promises(page)
    for number, line in enumerate(read(page).splitlines(), 1):
        if len(line) > 120 and not line.lstrip().startswith("|"):
            problems.append(f"{page}:{number}: {len(line)} columns")
    programs = {program_of(word) for block in blocks(page) for _, code in block.code() for word in code.split()}
    programs &= sources.keys()
    for block in blocks(page):
        for number, code in block.code():
            for part in re.split(r"&&|;", re.sub(r"(?:^|\s)# .*", "", code)):
                check_command(page, number, part.strip().removeprefix("$ "), programs)
            for word in code.split() if block.kind != "code" else []:
                check_place(page, number, word.rstrip(".,;:"))
                check_constant(page, number, word)
                check_test(page, number, word.rstrip(",;:"))
        if block.kind != "code":
            for link in re.finditer(r"\]\(([^)\s]+)\)", block.without_code()):
                check_link(page, block.line_at(link.start()), link[1])


def check_rules():
    rules = os.path.join(root, "host_tools/diagnosis/decision_rules.hpp")
    page = os.path.join(root, "host_tools/DIAGNOSIS.md")
    if not os.path.exists(page):
        return
    names = set(re.findall(r"^(?:constexpr|inline const) .*?\b(k[A-Z]\w*)\b", read(rules), re.M))
    text = read(page)
    problems.extend(f"{page}: {name} of {rules} is not in it" for name in names if f"`{name}`" not in text)
    # Other numbers stand with the file that has them.
    for name in set(re.findall(r"`(k[A-Z]\w*)`", text)) - names:
        files = re.findall(rf"`{name}`[^`)]*`([a-z_/]+\.[ch]pp)`", text)
        places = [os.path.join(root, "host_tools", "" if "/" in f else "diagnosis", f) for f in files]
        if not any(name in read(place) for place in places):
            problems.append(f"{page}: {name} is no rule, and no file is named that has it")


def check_version():
    citation = os.path.join(root, "CITATION.cff")
    if not os.path.exists(citation):
        return
    cited = re.search(r"^version: (\S+)", read(citation), re.M)[1]
    built = re.search(r"^\s*VERSION (\d\S+)", read(os.path.join(root, "CMakeLists.txt")), re.M)[1]
    if cited != built:
        problems.append(f"{citation}: version {cited}, the build has {built}")


count = 0
for page in of_type(".md"):
    check_page(page)
    count += 1
check_comments()
check_rules()
check_version()
print("\n".join(problem.replace(root + "/", "") for problem in problems), file=sys.stderr, end="\n" if problems else "")
if not problems:
    print(f"{count} pages: links, headings, files, commands, columns, names of rules")
sys.exit(bool(problems))
EOF
