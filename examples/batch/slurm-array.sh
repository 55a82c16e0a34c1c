#!/bin/sh
#SBATCH --job-name=teeth --array=1-20 --cpus-per-task=4 --mem=16G --time=2:00:00
# Many teeth as a job array: sbatch slurm-array.sh teeth.txt models [options of odontoscope batch]
# Each task makes every Nth tooth of the list; all share list and folder. When all have ended: odontoscope batch teeth.txt -o models [the same options], which keeps
# what they made, tries again what failed, and writes the one report.
list=$1 folder=$2
shift 2
exec odontoscope batch "$list" -o "$folder" --jobs "$SLURM_CPUS_PER_TASK" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" "$@"
