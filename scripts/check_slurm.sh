#!/bin/bash
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_slurm.sh SEGMENT_MESH MESHES
# Whether the manual's recipe for Slurm gives a table of all meshes: a cluster of this machine alone
# runs an array over lists, one task of which is cancelled, and then the same array again. Needs to
# be root, and the packages of `setup.sh cluster`.

set -euo pipefail

tool=$(realpath "$1")
meshes=$(realpath "$2")
manual=$(realpath "$(dirname "$0")/../doc/Many_meshes.txt")
work=$(mktemp -d)
chmod 755 "$work"
cd "$work"

stop() {
  pkill -F slurmd.pid || true
  pkill -F slurmctld.pid || true
  sleep 1
  rm -rf "$work"
}
trap stop EXIT

export SLURM_CONF=$work/slurm.conf PATH=$(dirname "$tool"):$PATH
cat > slurm.conf << EOF
ClusterName=check
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=main Nodes=$(hostname) Default=YES State=UP
EOF
mkdir -p state spool /run/munge
chown munge: /run/munge
munge -n > /dev/null 2>&1 || runuser -u munge -- munged
slurmctld
slurmd

find "$meshes" -name '[a-d]*.off' | sort | head -24 > all
split --lines 8 --suffix-length 4 --numeric-suffixes all list.
# The script as the manual has it
sed -n '/^    #!\/bin\/bash$/,/^$/s/^    //p' "$manual" > segment.sh
grep -q out-dir segment.sh

array() {
  sbatch --wait --array=0-2 --cpus-per-task=1 segment.sh || true # 1 if a task was cancelled
}
(sleep 2; scancel --jobname=segment.sh --state=RUNNING || true) &
array
array
wait
cat out/*/table.jsonl > table
rows=$(wc -l < table)
done=$(cut -d '"' -f 4 table | sort | uniq | comm -12 - all | wc -l)
echo "check_slurm.sh: $rows rows, for $done of $(wc -l < all) meshes"
[[ $rows -eq $(wc -l < all) && $done -eq $rows ]]
