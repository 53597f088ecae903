#!/usr/bin/env bash
# reference_document.sh FOGCOMP SOURCE [--renew]: host_tools/REFERENCE.md has every JSON key that the code writes and none
# that it does not, and every key of a model file. What checks pages by, tests/checks/command_options.txt, has every
# command's options. --renew writes these anew.
set -euo pipefail
exec python3 - "$@" <<'EOF'
import glob, os, re, subprocess, sys

fogcomp, source, renew = sys.argv[1], sys.argv[2], "--renew" in sys.argv[3:]
page = f"{source}/host_tools/REFERENCE.md"
options_file = f"{source}/tests/checks/command_options.txt"
problems = []


def said(*words):
    return subprocess.run([fogcomp, *words], capture_output=True, text=True, check=True).stdout


def read(*patterns):
    files = [file for pattern in patterns for file in glob.glob(f"{source}/host_tools/{pattern}")]
    return "\n".join(open(file, encoding="utf-8").read() for file in files)


def options_of(command):
    text = said("help", command)
    return re.findall(r"^  (--?[a-z][a-z-]*)", text.split("\nusage: ")[1].split("\nexample: ")[0], re.M)


text = open(page, encoding="utf-8").read()
sections = {m[2]: m[0] for m in re.finditer(r"^(###+) (.+)\n(?:(?!^##).*\n)*", text, re.M)}
commands = re.findall(r"^  ([a-z]+) ", said("--help"), re.M)
options = "".join(f"{command}: {' '.join(options_of(command))}".rstrip() + "\n" for command in commands)
if not os.path.exists(options_file) or open(options_file, encoding="utf-8").read() != options:
    problems.append(f"{options_file} is not as fogcomp help has it")

# JSON: keys by the files that write them.
everything = read("*/*.cpp", "*/*.hpp")
writers = {"add": ["findings/add_json.cpp"], "batch": ["findings/batch_json.cpp"], "fit": ["findings/fit_json.cpp"],
           "compare": ["findings/compare_json.cpp"], "info": ["findings/info_json.cpp"],
           "diagnose": ["findings/diagnosis_json.cpp"], "paper": ["findings/paper_json.cpp"],
           "plan": ["findings/plan_json.cpp"]}
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
    open(options_file, "w", encoding="utf-8").write(options)
    print("command_options.txt: options as the commands have them")
    sys.exit(0)
for problem in problems:
    print(problem, file=sys.stderr)
if problems:
    print("tests/integration/reference_document.sh FOGCOMP SOURCE --renew writes the options anew",
          file=sys.stderr)
else:
    print(f"{len(commands)} commands, {len(set(model_keys))} keys of a model file, as the tool has them")
sys.exit(bool(problems))
EOF
