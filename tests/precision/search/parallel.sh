#!/bin/sh
# The same on the cores of one machine, or of several (--sshlogin), by GNU parallel. Given again, it goes on. What there
# is is merged even if a shard found nothing or was stopped; the exit code then tells of it.
#   sh tests/precision/search/parallel.sh 8
set -eu
shards=${1:-$(nproc)} status=0
parallel --halt never graze-search --goal error --figure time/lagrange.stable/double --tries 1000 \
    --shard "{}/$shards" --out "found-{}.txt" ::: $(seq 0 $((shards - 1))) || status=$?
graze-search merge found.txt found-*.txt
exit "$status"
