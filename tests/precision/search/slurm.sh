#!/bin/sh
# A search over the tasks of a Slurm array, each a shard, and the merge when all of them have ended:
#   job=$(sbatch --parsable tests/precision/search/slurm.sh --goal error --figure time/lagrange.stable/double)
#   sbatch --dependency=afterany:$job --wrap 'graze-search merge found.txt found-*.txt'
# Takes the arguments of graze-search, or of the program that GRAZE_SEARCH names. SHARDS is the number of shards, 64 by
# default; the tasks are 0 to SHARDS - 1. If the time limit stopped tasks, submit the same command again, for all of them
# or, with --array=3,17, for some: each continues from its own file.
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
