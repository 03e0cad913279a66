#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A Slurm of one node, this machine, in a folder of its own. Needs root and the packages slurm-wlm and munge.
#   slurm.sh start FOLDER    writes FOLDER/slurm.conf, starts munged, slurmctld and slurmd, waits until the node is idle;
#                            exits 77 where that is not possible
#   slurm.sh stop FOLDER     ends them
#   slurm.sh kill-node FOLDER, slurm.sh start-node FOLDER    slurmd alone
set -uo pipefail
export PATH="$PATH:/usr/sbin:/sbin"
what=$1
folder=$2
export SLURM_CONF="$folder/slurm.conf"

end() {
    local file="$folder/$1" pid
    [[ -s $file ]] || return 0
    pid=$(<"$file")
    kill "${2:--TERM}" "$pid" 2>/dev/null
    for _ in {1..100}; do
        kill -0 "$pid" 2>/dev/null || break
        sleep 0.1
    done
    kill -KILL "$pid" 2>/dev/null
    rm -f "$file"
}

case $what in
    start)
        if ((EUID != 0)); then
            echo "slurm: this needs root" >&2
            exit 77
        fi
        for program in munged slurmctld slurmd sbatch squeue; do
            if ! command -v "$program" >/dev/null; then
                echo "slurm: $program is not there" >&2
                exit 77
            fi
        done
        host=$(hostname)
        mkdir -p "$folder/state" "$folder/spool"
        # libmunge looks for the socket here.
        mkdir -p /run/munge
        chown munge: /run/munge
        if ! munge -n >/dev/null 2>&1; then
            mkdir -p "$folder/munge"
            chown munge: "$folder/munge"
            chmod 755 "$folder"
            chmod 700 "$folder/munge"
            setpriv --reuid munge --regid munge --clear-groups munged --force --pid-file="$folder/munge/pid" \
                --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" || exit 77
        fi
        port=$((20000 + $$ % 20000))
        cat >"$SLURM_CONF" <<EOF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=cred_expire=5
SlurmUser=root
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0,bf_interval=1
KillWait=2
MinJobAge=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
EOF
        slurmctld || exit 77
        slurmd || exit 77
        for _ in {1..150}; do
            [[ $(sinfo --noheader --format=%t 2>/dev/null) == idle ]] && exit 0
            sleep 0.2
        done
        cat "$folder"/*.log >&2
        exit 1
        ;;
    stop)
        scancel --user=root 2>/dev/null
        end slurmd.pid
        end slurmctld.pid
        end munge/pid
        ;;
    kill-node) end slurmd.pid -KILL ;;
    start-node) slurmd ;;
    *) exit 2 ;;
esac
