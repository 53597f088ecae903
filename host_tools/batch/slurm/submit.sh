#!/usr/bin/env bash
# submit.sh TASKS DIR OUT [OPTION...]: calibrates the gyros of DIR by a Slurm job array of TASKS tasks, each of which
# runs `fogcomp calibrate` for its share. A last job, `fogcomp batch`, finds them calibrated and makes table and page.
# OPTIONs are those of `fogcomp batch`. Environment: SBATCH_OPTIONS, for the array, e.g. "--partition=lab
# --cpus-per-task=4 --time=2:00:00" (a task takes as many gyros at a time as it has processors); FOGCOMP, the program if
# it is not in the path. Prints the numbers of both jobs.
set -euo pipefail
tasks=${1:?usage: submit.sh TASKS DIR OUT [OPTION...]} input=${2:?DIR is missing} output=${3:?OUT is missing}
shift 3
options=("$@") of_gyro=()
fogcomp=${FOGCOMP:-fogcomp}
command -v "$fogcomp" >/dev/null || { echo "$fogcomp: not found; set FOGCOMP" >&2; exit 2; }
read -ra sbatch_options <<<"${SBATCH_OPTIONS:-}"
log=$output/slurm
mkdir -p "$log"

# What says how a lot is run and shown is not for its gyros.
for ((i = 0; i < ${#options[@]}; ++i)); do
  case ${options[i]} in
    --tables | --json | --jobs=* | --time-limit=*) ;;
    --jobs | --time-limit) ((++i)) ;;
    *) of_gyro+=("${options[i]}") ;;
  esac
done

# Scripts of the jobs, with any characters in the words. In the first, the task's shell knows its number.
{
  printf '#!/usr/bin/env bash\nls -d %q/*/ |\n' "$input"
  echo '  awk -v task="$SLURM_ARRAY_TASK_ID" -v tasks="$SLURM_ARRAY_TASK_MAX" "NR % tasks == task % tasks" |'
  echo -n '  parallel --plain --jobs "${SLURM_CPUS_PER_TASK:-1}" --quote'
  printf ' %q' "$fogcomp" calibrate {} -o "$output" --threads 1 "${of_gyro[@]}"
  echo
} >"$log/calibrate.sh"
{
  printf '#!/usr/bin/env bash\nexec'
  printf ' %q' "$fogcomp" batch "$input" -o "$output" "${options[@]}"
  echo
} >"$log/batch.sh"
array=$(sbatch "${sbatch_options[@]}" --parsable --job-name=fogcomp --array="1-$tasks" \
  --output="$log/task_%a.txt" <"$log/calibrate.sh")
last=$(sbatch --parsable --job-name=fogcomp-batch --dependency="afterany:$array" --output="$log/batch.txt" \
  <"$log/batch.sh")
echo "array $array, then $last; what they say: $log"
