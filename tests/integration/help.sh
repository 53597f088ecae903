#!/usr/bin/env bash
# help.sh FOGCOMP: every command's --help fits a screen and has a working example; `fogcomp help COMMAND`, the manual
# page and completion contain every option, because all use one description.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: help.sh FOGCOMP}")
enter_scratch
mkdir bin
ln -s "$fogcomp" bin/fogcomp
PATH=$PWD/bin:$PATH

mapfile -t commands < <(fogcomp --help | sed -nE 's/^  ([a-z]+) .*/\1/p')
((${#commands[@]} > 10)) || fail "commands: ${commands[*]}"
fogcomp man >fogcomp.1
(($(fogcomp --help | wc -L) <= 80)) || fail "--help is $(fogcomp --help | wc -L) columns wide"
manual=$(<fogcomp.1)
declare -A options # of each command
for command in "${commands[@]}"; do
  fogcomp "$command" --help >short
  (($(wc -l <short) <= 24)) || fail "$command --help has $(wc -l <short) lines"
  (($(wc -L <short) <= 80)) || fail "$command --help is $(wc -L <short) columns wide"
  (($(grep -c '^example: ' short) == 1)) || fail "$command --help has no example"
  # Every option has its entry in the manual, and at least its name on the screen.
  options[$command]=$(fogcomp help "$command" | sed -nE 's/^  (--?[a-z][a-z-]*).*/\1/p')
  screen=" $(<short) "
  for option in ${options[$command]}; do
    [[ $manual == *"\\fB${option//-/\\-}\\fR"* ]] || fail "$option is not in the manual"
    [[ $screen =~ [[:space:]:]$option[[:space:]] ]] || fail "$option is not in $command --help"
  done
done

# The manual is rendered without warnings.
if command -v man >/dev/null; then
  MANWIDTH=80 man -l --warnings=w fogcomp.1 >page.txt 2>complaints.txt
  [[ ! -s complaints.txt ]] || fail "man: $(head -n 3 complaints.txt)"
  grep -q 'fogcomp fit RUN...' page.txt || fail "the page lacks fit"
else
  echo "(no man here: the page was not rendered)"
fi

# Examples: each runs in a folder with the files it names.
mkdir files
(
  cd files
  fogcomp simulate -o run.csv >said.txt
  fogcomp simulate -o reversed.csv --profile reversed --seed 2 >said.txt
  fogcomp fit run.csv -o gyro.model --effects bias,bias_temperature >said.txt
  fogcomp export gyro.model -o fog_model.h --sample-rate 0.1 >said.txt
  cp gyro.model other.model
  mkdir -p gyros/G1
  cp run.csv gyros/G1
  echo "fit_rms_dph <= 1" >limits.txt
)
for command in "${commands[@]}"; do
  [[ $command != paper && $command != health && $command != load ]] ||
    continue # minutes: json_output.sh runs it with less to do; need a board
  example=$(fogcomp "$command" --help | sed -n '/^example: /,$ { s/^example: //; p; }')
  rm -rf here
  cp -r files here
  status=0
  (cd here && bash -euo pipefail -c "$example") >said.txt 2>errors.txt || status=$?
  [[ $command != workbench ]] || ! grep -q "built without" errors.txt || continue # no emscripten here
  ((status <= 1)) || fail "$example: exit code $status, $(cat errors.txt)" # 1: the answer is no
done

# complete WORD...: the completions of bash for the last word.
bash -n <(fogcomp completion bash)
# shellcheck disable=SC1090
source <(fogcomp completion bash)
compopt() { :; } # works only while bash completes
complete_words() {
  COMP_WORDS=(fogcomp "$@")
  COMP_CWORD=$#
  _fogcomp
}
# offered EXPECTED...: these are among the last completions. No pipe and no grep, of which there would be hundreds.
offered() {
  local word
  for word in "$@"; do
    [[ " ${COMPREPLY[*]} " == *" $word "* ]] || fail "fogcomp ${COMP_WORDS[*]:1}: no $word in ${COMPREPLY[*]}"
  done
}
# offers EXPECTED WORD...: it is one of the completions of the last word.
offers() {
  complete_words "${@:2}"
  offered "$1"
}
offers diagnose d
offers --effect-expr fit run.csv --eff
offers temperature_rate_product fit run.csv --effects temp
offers bias,bias_temperature fit run.csv --effects bias,bias_t
offers pso-bp fit --trainer pso
offers reversed simulate --profile rev
offers thermal_lag add gyro.model ther
offers polarization_ripple effects pol
offers --limits batch gyros --lim
complete_words fit --seed ''
[[ -z ${COMPREPLY[*]} ]] || fail "a number is completed"
for command in "${commands[@]}"; do
  complete_words "$command" -
  # shellcheck disable=SC2086
  offered ${options[$command]}
done
echo "${#commands[@]} commands: help, examples, manual and completion agree"
