#!/bin/sh
# A search over the tasks of a Slurm array, each a shard, and the merge when all of them have ended:
#   job=$(sbatch --parsable tests/precision/search/slurm.sh --goal error --figure time/lagrange.stable/double)
#   sbatch --dependency=afterany:$job --wrap 'graze-search merge found.txt found-*.txt'
# Arguments are those of graze-search, or of the program that GRAZE_SEARCH names. SHARDS, 64 unless given, is how many
# shards there are, and the tasks 0 to SHARDS - 1 make them all. Tasks that were stopped by the time limit are given
# again by the same command, all of them or, with --array=3,17, some, and each goes on from its own file.
#SBATCH --array=0-63
#SBATCH --time=04:00:00
#SBATCH --ntasks=1
#SBATCH --signal=B:TERM@60
#SBATCH --requeue
set -eu
if [ $# -eq 0 ]; then
    set -- --goal error --figure time/lagrange.stable/double --tries 100000
fi
exec "${GRAZE_SEARCH:-graze-search}" "$@" --shard "$SLURM_ARRAY_TASK_ID/${SHARDS:-64}" --out "found-$SLURM_ARRAY_TASK_ID.txt"
