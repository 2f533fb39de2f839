#!/usr/bin/env bash
# A sweep as a Slurm array: each job folds one part, and the last step puts the tables together.
#   sbatch deploy/slurm.sh && sbatch --dependency=singleton --job-name=origami-sweep --wrap "origami merge sweep -o sweep"
# A job that was killed is sent again as it is: it goes on with the rows that it has.
#SBATCH --job-name=origami-sweep
#SBATCH --array=1-16
#SBATCH --cpus-per-task=4
#SBATCH --time=01:00:00
#SBATCH --requeue
set -euo pipefail

# 3 means that some sheets did not converge, 2 that some diverged: their rows say so, and the job is done all the same.
origami sweep crane.fold --percent 0:100:0.1 --k-fold 0.1,0.7,7 -o sweep \
    --shard slurm --resume --threads "${SLURM_CPUS_PER_TASK:-1}" || [ $? -ge 2 ]
