#!/usr/bin/env bash
# score_is_right.sh SOURCE BUILD MADE: tests the score on the cases in MADE with answers of known score: an oracle gets
# everything, "none" for all names nothing, the same name for all is wrong; and the data of the answering side contain
# no truth.
set -euo pipefail
source=$1 build=$2 made=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cp -r "$made"/{runs,truth} "$scratch"
ids=("$scratch"/truth/*)
ids=("${ids[@]##*/}")

# The few cases may have none as small as 0.2 to 0.35: the first of 0.35 is copied and labelled 0.25.
for id in "${ids[@]}"; do
  grep -qE '^hidden .* 0\.35$' "$scratch/truth/$id/plan.txt" || continue
  small=dev$((${#ids[@]} + 1))
  for part in runs truth; do cp -r "$scratch/$part/$id" "$scratch/$part/$small"; done
  sed -i 's/ 0\.35$/ 0.25/; s/ 0\.3500$/ 0.2500/; s/^case .*/case '"$small"'/' "$scratch/truth/$small"/{plan,facts}.txt
  ids+=("$small")
  break
done

# answer ID JSON ADDED: an answer like that of answer_case.sh.
answer() {
  mkdir -p "$scratch/answers/$1"
  echo "$2" >"$scratch/answers/$1/diagnosis.json"
  echo "{\"added\":[$3]}" >"$scratch/answers/$1/loop.json"
  echo 1 >"$scratch/answers/$1/seconds.txt"
  echo made up >"$scratch/answers/$1/key"
}
named() {
  printf '{"verdict":"missing_effect","effect":"%s","confusable":[],"candidates":[{"effect":"%s","probability":1}]}\n' \
    "$1" "$1"
}

oracle() {
  local id=$1 plan=$scratch/truth/$1/plan.txt hidden added
  mapfile -t hidden < <(awk '$1 == "hidden" { print $2 }' "$plan")
  added=$(printf ',"%s"' ${hidden[@]+"${hidden[@]}"})
  case $(awk '$1 == "kind" { print $2 }' "$plan") in
    clean) answer "$id" '{"verdict":"none","effect":null,"confusable":[],"candidates":[]}' "" ;;
    foreign) answer "$id" '{"verdict":"unknown","effect":null,"confusable":[],"candidates":[]}' "" ;;
    *) answer "$id" "$(named "${hidden[0]}")" "${added#,}" ;;
  esac
}
always_none() { answer "$1" '{"verdict":"none","effect":null,"confusable":[],"candidates":[]}' ""; }
always_light() { answer "$1" "$(named light_power)" '"light_power"'; }

# scored ANSWERER: answers and scores all cases.
scored() {
  local id
  for id in "${ids[@]}"; do "$1" "$id"; done
  "$source/tests/bench/hidden_effects.sh" --cases "${#ids[@]}" --build "$build" -o "$scratch" --stages score \
    >"$scratch/$1.txt" 2>"$scratch/progress.txt"
}
# expect MEASURE VALUE: in results.json; a measure without cases is null.
expect() {
  cat >"$scratch/check.cmake" <<SCRIPT
file(READ "$scratch/results.json" text)
string(JSON value GET "\${text}" measures $1 value)
if(NOT value EQUAL $2)
  message(FATAL_ERROR "$1 is \${value}, not $2")
endif()
SCRIPT
  cmake -P "$scratch/check.cmake"
}

scored oracle
sed -n '/^| measure/,/^$/p' "$scratch/oracle.txt"
for measure in single_name_right in_set_0.2 in_set_0.35 in_set_0.6 single_right_0.6 unknown_0.7_all unknown_2_all \
  both_found_all; do
  expect $measure 1
done
for measure in clean_named clean_not_none superfluous calibration failed; do expect $measure 0; done

scored always_none
for measure in clean_named clean_not_none in_set_0.2 in_set_0.6 single_right_0.6 unknown_0.7_all both_found_all \
  superfluous; do
  expect $measure 0
done

scored always_light
expect clean_named 1
expect clean_not_none 1
expect unknown_2_all 0
grep -q 'light_power for (clean)' "$scratch/always_light.txt"

# The answering side's data do not name the hidden effect.
for id in "${ids[@]}"; do
  for file in "$scratch/runs/$id"/*; do
    [[ ${file##*/} =~ ^(run[1-9]\.csv|unseen\.csv|effects\.txt|request\.txt)$ ]] ||
      { echo "$file: for whom?" >&2; exit 1; }
  done
  ! grep -l '^#' "$scratch/runs/$id"/*.csv || { echo "$id: a recording has comments" >&2; exit 1; }
done
for id in "${ids[@]}"; do
  # In the files as in the trial: the requested sizes, and declared effects described by their formulas.
  awk '$1 == "hidden" { size[$2] = $4 }
       $1 == "visible" && !($3 > 0.97 * size[$2] && $3 < 1.03 * size[$2]) { print FILENAME, $0; bad = 1 }
       $1 == "misfit_beside_delays" {
         seen = 1
         if (!($2 ~ /^[0-9.]+$/ && $2 <= 0.101)) { print FILENAME, $0; bad = 1 }
       }
       END { exit bad || !seen }' "$scratch/truth/$id/plan.txt" "$scratch/truth/$id/facts.txt"
done
echo "an oracle is scored as one, none and nonsense as what they are"
