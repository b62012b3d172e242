#!/bin/sh
# check.sh ROOT WORK: tests the script `graze` in a copy of the tree, with stand-ins for all that it would change or build.
# shellcheck disable=SC2016  # the stand-ins expand what is in single quotes
set -eu
root=$1 work=$2
rm -rf "$work"
mkdir -p "$work/bin" "$work/tree/.ci" "$work/elsewhere"
cp "$root/graze" "$work/tree"
printf '# remark\nhere\nabsent\n' >"$work/tree/.ci/packages-compare.txt"
printf 'absent-too # remark\nunknown\n' >"$work/tree/.ci/packages-test.txt"
printf 'absent-three\n' >"$work/tree/.ci/packages-report.txt"

# Each stand-in logs how it was called. Only "here" is installed; "unknown" does not exist.
stand_in() { printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\n%s\n' "$1" "$work" "$2" >"$work/bin/$1"; }
stand_in dpkg-query 'case $* in *here) echo installed ;; *) exit 1 ;; esac'
stand_in apt-cache 'echo absent-three; echo absent-too; echo absent'
stand_in apt-get 'case $* in *--simulate) echo "Inst ${SIMULATED:-absent} (1.0)"; exit ;; install*) exit ${INSTALL_STATUS:-0} ;; esac
exit ${APT_STATUS:-0}'
stand_in sudo '"$@"'
stand_in id 'echo ${USER_ID:-0}'
stand_in cmake 'echo "noise of cmake"; echo "-- graze: a remark"
case $1 in --build) echo "[1/20] Building"; echo "[ 7%] Building"; echo "[11/20] Building"; exit ${BUILD_STATUS:-0} ;; esac
exit ${CMAKE_STATUS:-0}'
stand_in ctest ''
stand_in c++ ''
stand_in ninja ''
chmod +x "$work"/bin/*
program=build/release/examples/compare/graze-compare
mkdir -p "$work/tree/${program%/*}"
for program in "$program" "$program-plane"; do
    printf '#!/bin/sh\nprintf "%s in %%s:" "$(pwd)"\nprintf " <%%s>" "$@"\n' "${program##*/}" >"$work/tree/$program"
    chmod +x "$work/tree/$program"
done
peers=build/release/tests/speed/peers/graze-peers
mkdir -p "$work/tree/${peers%/*}"
printf '#!/bin/sh\nprintf "graze-peers:"; printf " <%%s>" "$@"\n' >"$work/tree/$peers"
chmod +x "$work/tree/$peers"
PATH=$work/bin:$PATH
export PATH

failures=0
# run STATUS ARGUMENT...: runs graze from another directory.
run() {
    expected=$1 status=0
    shift
    : >"$work/calls"
    (cd "$work/elsewhere" && ../tree/graze "$@") >"$work/out" 2>"$work/err" || status=$?
    what="graze $*"
    [ "$status" -eq "$expected" ] || complain "ended with $status, not $expected"
}
complain() {
    failures=$((failures + 1))
    printf '%s: %s\n' "$what" "$1"
    cat "$work/out" "$work/err" "$work/calls"
}
has() { grep -qe "$2" "$work/$1" || complain "'$2' is not in $1"; }
lacks() { ! grep -qe "$2" "$work/$1" || complain "'$2' is in $1"; }

run 2; has err 'compare, report or test'; lacks calls .
run 2 comapre; has err "unknown command 'comapre'"; lacks calls .
run 2 --fast compare; has err "unknown command '--fast'"
run 0 report --help; has out Usage; lacks calls .
run 2 report -x; has err "a folder, not '-x'"; lacks calls .
run 0 --help; has out '^Usage: ./graze compare'; lacks calls .

run 0 compare
has out 'installing with apt: absent$'
has calls '^apt-get update'
has calls '^apt-get install .* absent$'
has calls '^cmake --preset release -DGRAZE_BUILD_TESTS=OFF'
has calls '^cmake --build build/release --target graze-compare-plane '
has out "graze-compare-plane in .*/elsewhere: <--report> <graze-report.html>"
has out '^-- graze: a remark'
has err '^graze: building 1/20$'
lacks err '7%' # no tenth
has err '^graze: building 11/20$'
lacks err noise
lacks calls graze-compare-run
lacks calls sudo
lacks calls ctest

run 0 compare --no-install --types 'double,long double' 'a b'
lacks calls apt-get
has out ': <--types> <double,long double> <a b>$'
run 0 --no-install compare --help; has out ': <--help>$'
echo '{"dimension": 2}' >"$work/elsewhere/plane.json"
printf '{ "dimension" :\n3}' >"$work/elsewhere/a room.json"
run 0 compare --no-install --scene plane.json --json out.json; has out '^graze-compare-plane in .*: <--scene> <plane.json>'
for argument in 'a room.json' '--scene=a room.json' --dimension=3 - /dev/null; do
    run 0 compare --no-install "$argument"
    has calls '^cmake --build build/release --target graze-compare '; has out "^graze-compare in .*: <$argument>$"
done

touch "$work/tree/build/release/CMakeCache.txt" # a tree that was configured keeps its tests
run 0 compare --no-install; lacks calls GRAZE_BUILD_TESTS

run 0 test -R 'a b'
has out 'installing with apt: absent absent-too unknown$'
has err 'not in this distribution, done without: unknown'
has calls '^apt-get install .* absent absent-too$'
has calls '^cmake --preset test -DGRAZE_BUILD_TESTS=ON'
has calls '^cmake --build build/test --target all'
has calls '^ctest --preset test .*-R a b'
has calls '^cmake --preset test -DGRAZE_BUILD_TESTS=ON -DGRAZE_STANDARD_ALONE=ON' # while apt installs
has calls '^cmake --preset test -DGRAZE_BUILD_TESTS=ON -DGRAZE_STANDARD_ALONE=OFF'
SIMULATED='c++ [0.9]'; export SIMULATED # would be replaced
run 0 test; has calls '^apt-get install .* absent absent-too$'; lacks calls STANDARD_ALONE=ON
unset SIMULATED
INSTALL_STATUS=100; export INSTALL_STATUS
run 100 test; has err 'this failed: as_root env .* apt-get install'; lacks calls STANDARD_ALONE=OFF; lacks calls ctest
run 100 compare; lacks calls cmake
unset INSTALL_STATUS
BUILD_STATUS=3; export BUILD_STATUS
run 1 test; has calls '^apt-get install .* absent-too$'; has err 'could not be built: all'; lacks calls STANDARD_ALONE=OFF
unset BUILD_STATUS

run 0 report --no-install 'a book'
has calls '^cmake --build build/release --target graze-compare graze-peers'
has calls '^cmake --preset release -DGRAZE_BUILD_TESTS=ON'
has out 'a book/index.html$'
what='the book'; cp "$work/elsewhere/a book/types.txt" "$work/elsewhere/a book/peers.md" "$work"
has types.txt '<--json> <a book/types.json>$'
has peers.md '<--book> <a book> <--with> <a book/types.json> <--with> <a book/near_contact.json>$'
run 0 report; has out 'installing with apt: absent absent-too unknown absent-three$'
run 2 report --no-install one two; has err 'one folder, not 2'

APT_STATUS=100; export APT_STATUS
run 100 compare; has err 'this failed: as_root apt-get update'; lacks calls cmake
unset APT_STATUS
run 0 compare --no-install run scene.json
has calls '^cmake --build build/release --target graze-compare-plane graze-compare-run '
has out ': <run> <scene.json>$'
BUILD_STATUS=3; export BUILD_STATUS
run 1 compare --no-install; has err 'noise of cmake'; has err 'could not be built: graze-compare'; lacks out 'graze-compare.* in'
unset BUILD_STATUS
CMAKE_STATUS=3; export CMAKE_STATUS
run 3 compare --no-install; has err 'noise of cmake'; lacks out graze-compare
unset CMAKE_STATUS

USER_ID=1000; export USER_ID
run 0 compare; has calls '^sudo apt-get update'

echo here >"$work/tree/.ci/packages-compare.txt" # nothing is missing: nothing is done
run 0 compare; lacks calls apt-get; lacks calls sudo; lacks out installing
[ "$failures" -eq 0 ]
