#!/bin/sh
# A search over 64 tasks of a Slurm array, and the merge when all of them have ended:
#   job=$(sbatch --parsable tests/precision/search/slurm.sh)
#   sbatch --dependency=afterany:$job --wrap 'graze-search merge found.txt found-*.txt'
# Tasks that were stopped by the time limit are given again by the same command: each goes on from its own file.
#SBATCH --array=0-63
#SBATCH --time=04:00:00
#SBATCH --ntasks=1
#SBATCH --signal=TERM@60
#SBATCH --requeue
exec graze-search --goal error --figure time/lagrange.stable/double --tries 100000 \
    --shard "$SLURM_ARRAY_TASK_ID/64" --out "found-$SLURM_ARRAY_TASK_ID.txt"
