#!/usr/bin/env bash
# submit.sh TASKS DIR OUT [OPTION...]: runs `fogcomp batch DIR -o OUT OPTION...` as a Slurm job array of TASKS tasks,
# followed by a job that makes table and page. Environment: SBATCH_OPTIONS, for the array, e.g. "--partition=lab
# --cpus-per-task=4 --time=2:00:00" (a task processes as many gyros at a time as it has processors); FOGCOMP, the
# program if it is not in the path. Prints the numbers of both jobs.
set -euo pipefail
tasks=${1:?usage: submit.sh TASKS DIR OUT [OPTION...]} input=${2:?DIR is missing} output=${3:?OUT is missing}
options=("${@:4}")
fogcomp=${FOGCOMP:-fogcomp}
command -v "$fogcomp" >/dev/null || { echo "$fogcomp: not found; set FOGCOMP" >&2; exit 2; }
read -ra sbatch_options <<<"${SBATCH_OPTIONS:-}"
mkdir -p "$output/slurm"

# Script of a job: the command line as typed, with any characters.
job() {
  printf '#!/usr/bin/env bash\nexec'
  printf ' %q' "$fogcomp" batch "$input" -o "$output" "$@"
}
log=$output/slurm
share='--shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_MAX" --jobs "${SLURM_CPUS_PER_TASK:-1}"' # for the task's shell
array=$({ job "${options[@]}"; echo " $share"; } |
  sbatch "${sbatch_options[@]}" --parsable --job-name=fogcomp --array="1-$tasks" --output="$log/task_%a.txt")
merge=$({ job "${options[@]}" --merge; echo; } |
  sbatch --parsable --job-name=fogcomp-merge --dependency="afterany:$array" --output="$log/merge.txt")
echo "array $array, merge $merge; what they say: $log"
