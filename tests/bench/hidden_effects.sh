#!/usr/bin/env bash
# hidden_effects.sh [--quick] [--wide] [--seeds dev|final|second|third] [--cases N|FIRST-LAST] [--case ID]
# [--jobs N] [--stages LIST] [--build DIR] [-o DIR]: how well `fogcomp diagnose` names what is hidden in simulated gyros
# (hidden_effects/README.md). Stages: make, answer, propose, told, score. Resumes: a case is made or answered again only
# where something it depends on has changed.
set -euo pipefail
source=$(realpath "$(dirname "$0")/../..")
here=$source/tests/bench/hidden_effects
seeds=dev wide='' cases='' jobs=$(nproc) out='' build=$source/build/host stages=make,answer,propose,told,score only=''
while (($#)); do
  case $1 in
    --quick) cases=116; shift; continue ;;
    --wide) wide=wide-; shift; continue ;;
    --seeds | --cases | --case | --jobs | --stages | --build | -o) (($# >= 2)) ||
      { echo "$1 needs a value" >&2; exit 2; } ;;
    *) sed -n '2,5s/^# //p' "$0" >&2; exit 2 ;;
  esac
  case $1 in
    --seeds) seeds=$2 ;;
    --cases) cases=$2 ;;
    --case) only=$2 ;;
    --jobs) jobs=$2 ;;
    --stages) stages=$2 ;;
    --build) build=$(realpath "$2") ;;
    -o) out=$2 ;;
  esac
  shift 2
done
[[ $seeds =~ ^(dev|final|second|third)$ ]] || { echo "--seeds $seeds: dev, final, second or third" >&2; exit 2; }
[[ $stages =~ ^(make|answer|propose|told|score)(,(make|answer|propose|told|score))*$ ]] ||
  { echo "--stages $stages: some of make,answer,propose,told,score" >&2; exit 2; }
seeds=$wide$seeds cases=${cases:-$([[ $wide ]] && echo 290 || echo 1508)}
[[ $cases =~ ^([0-9]+-)?[0-9]+$ ]] || { echo "--cases $cases: how many, or FIRST-LAST" >&2; exit 2; }
first=1
[[ $cases != *-* ]] || first=${cases%-*} cases=${cases#*-}
out=$(realpath -m "${out:-$build/hidden_effects${wide:+_wide}}")
fogcomp=$build/fogcomp programmes=$build/tests/bench/hidden_effects
[[ -x $fogcomp && -x $programmes/plan_case ]] ||
  { echo "no programmes in $build; cmake --preset host -DFOG_TESTS=ON && cmake --build build/host" >&2; exit 2; }
mkdir -p "$out"

if [[ $only ]]; then
  ids=("$only")
  export KEEP=1 # the rows of the truth stay, for a look
else
  mapfile -t ids < <(seq -f "$seeds%.0f" "$first" "$cases")
fi

wants() { [[ ,$stages, == *,$1,* ]]; }

# each WHAT COMMAND...: COMMAND ID for every case that stdin names, $jobs at a time; says how far it is.
each() {
  local what=$1 list done=0 begun=$SECONDS failed=$out/failed_${1// /_}.txt
  shift
  mapfile -t list
  : >"$failed"
  while read -r; do
    ((++done % 50 && done < ${#list[@]})) || echo "$what: $done of ${#list[@]}, $((SECONDS - begun)) s" >&2
  done < <(printf '%s\n' "${list[@]}" | xargs -r -P "$jobs" -n 1 bash -c '"${@:2}" || echo "${@: -1}" >>"$1"; echo' \
    each "$failed" "$@")
  [[ ! -s $failed ]] || { echo "$what: $(wc -l <"$failed") cases failed, listed in $failed" >&2; exit 1; }
}

echo "hidden_effects: ${#ids[@]} cases of the $seeds seeds, $jobs jobs, in $out" >&2
simulator=$(cksum <"$build/host_tools/libfogcomp_simulation.a" | tr ' ' -)
tool=$(cksum <"$fogcomp" | tr ' ' -)
if wants make; then
  # What recordings depend on: the simulator and the programmes that draw the cases.
  made_by=$simulator-$(cat "$programmes"/{plan_case,case_facts} | cksum | tr ' ' -)
  printf '%s\n' "${ids[@]}" | each make "$here/make_case.sh" "$fogcomp" "$programmes" "$out" "$made_by"
fi
if wants answer; then
  "$fogcomp" diagnose --help >/dev/null 2>&1 || { echo "skipped: $fogcomp has no command diagnose" >&2; exit 77; }
  printf '%s\n' "${ids[@]}" | each answer "$here/answer_case.sh" "$fogcomp" "$out" "$tool"
fi
if wants propose; then
  printf '%s\n' "${ids[@]}" | each propose "$here/propose_case.sh" "$fogcomp" "$out" "$simulator"
  (cd "$out/runs" && for id in "${ids[@]}"; do ls -d "$id.proposed" "$id.random" 2>/dev/null || true; done) |
    each "answer with one more run" "$here/answer_case.sh" "$fogcomp" "$out" "$tool"
fi
if wants told; then
  { (cd "$out/truth" && grep -lE '^kind (three|rate)$' "${ids[@]/%//plan.txt}") || true; } | sed 's|/plan.txt||' |
    each tell "$here/told_case.sh" "$fogcomp" "$out" "$tool"
fi
if wants score; then
  printf '%s\n' "${ids[@]}" >"$out/cases.txt"
  for id in "${ids[@]}"; do
    grep -q '^kind form$' "$out/truth/$id/plan.txt" || continue
    "$programmes/form_likeness" "$out/runs/$id" "$out/truth/$id" "$out/answers/$id"
  done
  "$programmes/score" "$out" | tee "$out/results.txt"
fi
