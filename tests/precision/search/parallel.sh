#!/bin/sh
# A search on the cores of one machine or of several (--sshlogin), by GNU parallel. The same command continues it. The
# files are merged even if a shard found nothing or was stopped; the exit code then says so.
#   sh tests/precision/search/parallel.sh 8 --goal farthest --figure encounter/lagrange.stable/double --tries 1000
set -eu
shards=${1:-$(nproc)} search=${GRAZE_SEARCH:-graze-search} status=0
if [ $# -gt 0 ]; then
    shift
fi
if [ $# -eq 0 ]; then
    set -- --goal error --figure time/lagrange.stable/double --tries 1000
fi
parallel --halt never "$search" "$@" --shard "{}/$shards" --out "found-{}.txt" ::: $(seq 0 $((shards - 1))) || status=$?
"$search" merge found.txt found-*.txt
exit "$status"
