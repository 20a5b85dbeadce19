#!/usr/bin/env bash
# A SLURM cluster of this machine alone, for tests: one_node.sh start FOLDER, one_node.sh stop FOLDER.
# Needs root and Debian's packages slurm-wlm and munge; systemd, cgroups and accounting are not used.
set -euo pipefail
action=$1 folder=$2

start() {
    mkdir -p "$folder"/{munge,spool,state,log} /etc/slurm
    # munged insists on folders that no one else may write to.
    chmod 0755 "$folder" "$folder/munge"
    [ -e "$folder/munge/key" ] || (umask 077 && head -c 1024 /dev/urandom >"$folder/munge/key")
    munged --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
        --pid-file="$folder/munge/pid" --log-file="$folder/log/munged" --seed-file="$folder/munge/seed"
    # The executor takes every SLURM_* variable away, so that only this place is read.
    cat >"$folder/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerType=sched/backfill
ReturnToService=2
MinJobAge=300
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld
SlurmdLogFile=$folder/log/slurmd
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=4000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
    if [ -e /etc/slurm/slurm.conf ] && [ ! -L /etc/slurm/slurm.conf ]; then
        echo "/etc/slurm/slurm.conf is there: this machine has a cluster of its own." >&2
        exit 1
    fi
    ln -sfn "$folder/slurm.conf" /etc/slurm/slurm.conf
    slurmctld
    slurmd
    for _ in $(seq 100); do
        if sinfo --noheader --format=%T 2>/dev/null | grep -q idle; then exit 0; fi
        sleep 0.1
    done
    echo "The node did not come up; see $folder/log." >&2
    exit 1
}

stop() {
    for pid in slurmd.pid slurmctld.pid munge/pid; do
        if [ -e "$folder/$pid" ]; then kill "$(cat "$folder/$pid")" || true; fi
    done
    if [ "$(readlink /etc/slurm/slurm.conf)" = "$folder/slurm.conf" ]; then rm /etc/slurm/slurm.conf; fi
}

"$action"
