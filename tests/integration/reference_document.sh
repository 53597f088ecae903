#!/usr/bin/env bash
# reference_document.sh FOGCOMP SOURCE [--renew]: host_tools/REFERENCE.md has every command's usage and the names of its
# options as `fogcomp help` says them, every JSON key that the code writes and none that it does not, and every key of a
# model file. --renew writes usage and options anew.
set -euo pipefail
exec python3 - "$@" <<'EOF'
import glob, re, subprocess, sys, textwrap

fogcomp, source, renew = sys.argv[1], sys.argv[2], "--renew" in sys.argv[3:]
page = f"{source}/host_tools/REFERENCE.md"
problems = []


def said(*words):
    return subprocess.run([fogcomp, *words], capture_output=True, text=True, check=True).stdout


def read(*patterns):
    files = [file for pattern in patterns for file in glob.glob(f"{source}/host_tools/{pattern}")]
    return "\n".join(open(file, encoding="utf-8").read() for file in files)


def one_line(text):
    return " ".join(text.split())


def command_help(command):
    """Its usage and purpose as a line, and its options with their values, by name."""
    text = said("help", command)
    purpose = one_line(re.search(rf"fogcomp {command} - (.*?)\n\nusage", text, re.S)[1])
    usage = one_line(re.search(r"^usage: (.*?)\n\n", text, re.M | re.S)[1])
    options = re.findall(r"^  ((--?[a-z][a-z-]*)(?: \S+)?)", text.split("\nusage: ")[1].split("\nexample: ")[0], re.M)
    return f"`{usage}`: {purpose}.", {name: option for option, name in options}


def wrapped(text):
    """An option stays with its value."""
    whole = re.sub(r"`[^`]+`", lambda code: code[0].replace(" ", "\0"), text)
    return "\n".join(textwrap.wrap(whole, 120, break_on_hyphens=False, break_long_words=False)).replace("\0", " ")


def options_paragraph(section):
    found = re.search(r"^Options: (?:.+\n)+", section, re.M)
    return found[0].rstrip("\n") if found else ""


def options_in(section):
    return [one_line(option) for option in re.findall(r"`(--?[a-z][^`]*)`", options_paragraph(section))]


def groups_in(section):
    return re.findall(r"\[[^]]+\]\(#[^)]+\)", one_line(options_paragraph(section)))


text = open(page, encoding="utf-8").read()
sections = {m[2]: m[0] for m in re.finditer(r"^(###+) (.+)\n(?:(?!^##).*\n)*", text, re.M)}
commands = re.findall(r"^  ([a-z]+) ", said("--help"), re.M)
helps = {command: command_help(command) for command in commands}


def replace_or_complain(section, wanted, present, what):
    """The same section with what is wanted in the place of what is present."""
    if wanted != present:
        problems.append(f"REFERENCE.md, {section}: {what}: wanted\n{wanted}\nthere is\n{present}")
    return wanted


for command in commands:
    section = sections.get(command)
    if section is None:
        problems.append(f"REFERENCE.md: no section '### {command}'")
        continue
    usage, options = helps[command]
    fresh = section
    present = re.search(r"^`fogcomp [^`]*`: (?:.+\n)+", section, re.M)[0].rstrip("\n")
    if replace_or_complain(command, usage, one_line(present), "usage") != one_line(present):
        fresh = fresh.replace(present, wrapped(usage), 1)
    own = dict(options)
    groups = groups_in(section)
    for group in groups:
        title = re.match(r"\[([^]]+)", group)[1].capitalize()
        there = options_in(sections[title])
        shared = [own.pop(name) for name in [option.split()[0] for option in there] if name in own]
        if shared != there:
            problems.append(f"REFERENCE.md: {command} has not the {title.lower()} of the group")
    listed = ", ".join([*(f"`{option}`" for option in own.values()), *groups])
    wanted = f"Options: {listed}." if listed else ""
    present = options_paragraph(section)
    if replace_or_complain(command, wanted, one_line(present), "options") != one_line(present):
        fresh = fresh.replace(present, wrapped(wanted), 1)
    text = text.replace(section, fresh, 1)

# JSON: keys by the files that write them.
everything = read("*/*.cpp", "*/*.hpp")
writers = {"add": ["findings/add_json.cpp"], "batch": ["findings/batch_json.cpp"], "fit": ["findings/fit_json.cpp"],
           "compare": ["findings/compare_json.cpp"], "info": ["findings/info_json.cpp"],
           "diagnose": ["findings/diagnosis_json.cpp"], "paper": ["findings/paper_json.cpp"],
           "plan": ["findings/plan_json.cpp"],
           "effects": ["cli/effects_command.cpp", "cli/effects_text.cpp"]}
for command in commands:
    section = sections.get(command, "")
    code = read(*writers.get(command, [f"cli/{command}_command.cpp"]))
    keys = set(re.findall(r"\bset\(\s*\"([a-z_0-9]+)\"", code))
    for key in sorted(keys):
        if f"`{key}`" not in section:
            problems.append(f"REFERENCE.md, {command}: JSON key {key} is missing")
    stated = re.findall(r"`([a-z]+(?:_[a-z0-9]+)+)`", section.partition("**JSON**")[2])
    for key in stated:
        if f'"{key}"' not in everything and not any(f'"{key[i:]}"' in everything for i in range(1, len(key))):
            problems.append(f"REFERENCE.md, {command}: no code writes {key}")

model_keys = re.findall(r"^    \{\"([a-z_0-9]+)\",", read("model/model_file.cpp", "model/model_lines.hpp"), re.M)
model_text = text[text.index("\n## Model file"):]
for key in model_keys:
    if f"`{key}`" not in model_text:
        problems.append(f"REFERENCE.md, Model file: {key} is missing")

if renew:
    open(page, "w", encoding="utf-8").write(text)
    print("REFERENCE.md: usage and options as the commands say them")
    sys.exit(0)
for problem in problems:
    print(problem, file=sys.stderr)
if problems:
    print("tests/integration/reference_document.sh FOGCOMP SOURCE --renew writes usage and options anew",
          file=sys.stderr)
else:
    print(f"{len(commands)} commands, {len(set(model_keys))} keys of a model file, as the tool has them")
sys.exit(bool(problems))
EOF
