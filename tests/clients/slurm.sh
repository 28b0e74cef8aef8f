#!/usr/bin/env bash
# Renders 120 frames of smoke in air by Slurm on this machine, in 15 tasks, and kills its daemon with the tasks that it runs in the middle.
#   slurm.sh <fumage-cli> [log folder]
# Needs slurmctld, slurmd and slurm-client (22.05 of Debian 12), python3, and to be root. No munge, no systemd: controller and daemon listen on the
# loopback, in a folder of their own, and are ended by their process ids. What must hold: tasks that were lost are done again, all frames are there,
# a task that ended with "try again" or was killed is tried again, `verify` finds nothing, the joined sheet is there, and every frame has the same bytes as one process gives it.
set -euo pipefail
cli=$(realpath "$1")
work=$(mktemp -d)
logs=${2:-$work}
mkdir -p "$logs"
export SLURM_CONF=$work/slurm.conf FUMAGE_CLI=$work/flaky
controller='' daemon=''

finish() {
    for process in $daemon $controller; do
        kill "$process" 2> /dev/null || true
        wait "$process" 2> /dev/null || true
    done
    rm -rf "$work"
}
trap finish EXIT

free_port() {
    python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

configure() {
    mkdir -p "$work/state" "$work/spool"
    cat > "$SLURM_CONF" << CONF
ClusterName=fumage
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
MpiDefault=none
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ReturnToService=2
SlurmdTimeout=10
BatchStartTimeout=1
MessageTimeout=5
KillWait=1
JobRequeue=1
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
}

# wait_for <seconds> <what> <command>...: asks until a command says yes.
wait_for() {
    local end=$((SECONDS + $1)) what=$2
    shift 2
    until "$@" > /dev/null 2>&1; do
        ((SECONDS < end)) || { echo "waited in vain for $what"; squeue || true; exit 1; }
        sleep 0.1
    done
}
is_up() { sinfo -h -o %T | grep -E '^(idle|mixed|allocated)$' > /dev/null; }
frames_there() { find "$work/frames" -name '*.exr' | wc -l; }
is_over() { [ -z "$(squeue -h)" ]; }

start_daemon() {
    slurmd -D >> "$logs/slurmd.log" 2>&1 &
    daemon=$!
}

# What Slurm has started from this folder: the programs that watch over steps, and the steps.
processes_of_tasks() {
    local environment process
    for environment in /proc/[0-9]*/environ; do
        process=${environment#/proc/}
        process=${process%/environ}
        if [ "$process" != "$daemon" ] && tr '\0' '\n' < "$environment" 2> /dev/null | grep -x "SLURM_CONF=$SLURM_CONF" > /dev/null &&
            { [ "$(cat "/proc/$process/comm")" = slurmstepd ] || tr '\0' '\n' < "$environment" 2> /dev/null | grep '^SLURM_ARRAY_JOB_ID=' > /dev/null; }; then
            echo "$process"
        fi
    done 2> /dev/null
}

# A machine that goes down: the daemon, and all that it runs.
kill_machine() {
    local tasks process
    mapfile -t tasks < <(processes_of_tasks)
    for process in "$daemon" "${tasks[@]}"; do
        kill -9 "$process" 2> /dev/null || true
    done
    wait "$daemon" 2> /dev/null || true
    echo "killed the daemon and ${#tasks[@]} processes of its tasks, with $(frames_there) frames there"
    ((${#tasks[@]} > 0)) || { echo "no task was running"; exit 1; }
}

# The program, but the first time that frames 16 to 23 are asked for there is no room on the disk, the first time that 32 to 39 are, it is killed as the
# kernel kills what has taken all memory, and the first time that 48 to 55 are, it gets no farther than the middle.
cat > "$FUMAGE_CLI" << FLAKY
#!/bin/bash
if [[ " \$* " == *" 16-23 "* ]] && mkdir "$work/failed" 2> /dev/null; then
    exit 75
fi
if [[ " \$* " == *" 32-39 "* ]] && mkdir "$work/killed" 2> /dev/null; then
    "$cli" "\$@" &
    kill -9 \$!
    kill -9 \$\$
fi
if [[ " \$* " == *" 48-55 "* ]] && mkdir "$work/begun" 2> /dev/null; then
    "$cli" "\${@/48-55/48-51}"
    mkdir "$work/middle"
    sleep 600
fi
exec "$cli" "\$@"
FLAKY
chmod +x "$FUMAGE_CLI"

configure
slurmctld -D -c > "$logs/slurmctld.log" 2>&1 &
controller=$!
start_daemon
wait_for 30 "Slurm" is_up

smoke=(plume --frames 0-119 --size 96 --set emitter.count=20000 --set air.resolution=48 --set noise.slices=4 --set noise.resolution=32)
"$cli" farm "${smoke[@]}" --for slurm --chunk 8 --then flipbook --output "$work/frames/smoke_####.exr" > "$work/submit"
(cd "$work" && bash "$work/submit")
wait_for 240 "the middle of a task" test -d "$work/middle"
kill_machine
start_daemon
wait_for 60 "the daemon" is_up
wait_for 500 "the jobs" is_over
grep -oE 'requeu[a-z]*.*' "$logs/slurmctld.log" | sort | uniq -c | sed -n 1,5p || true
"$cli" verify "$work/frames" --frames 0-119
ls "$work"/frames/smoke.*.manifest.json | wc -l | sed 's/$/ parts of the manifest/'
test -s "$work/frames/smoke.sheet.png"
test -d "$work/failed"
test -d "$work/killed"
"$cli" --quiet render "$work/frames/smoke.fumage.json" --frames 0-119 --format exr --manifest --output "$work/whole/smoke_####.exr"
for frame in "$work"/whole/*.exr; do
    cmp "$frame" "$work/frames/$(basename "$frame")"
done
echo "120 frames by Slurm have the same bytes as those of one process."
