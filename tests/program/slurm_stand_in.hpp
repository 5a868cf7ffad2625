/// Stand-ins for Slurm's commands, which run each task at once.
#pragma once

#include "tests/program/program.hpp"

namespace castaway::test {

/// Runs the tasks of --array, or the script. Task 2 is lost the first time if there is a file
/// "lose". Jobs are numbered from 71 on; each call is noted in "calls".
inline constexpr const char* kSbatch = R"(#!/bin/bash
here=$(dirname "$0")
echo "$*" >>"$here/calls"
script="${@: -1}"
for word in "$@"; do case $word in --array=*) array=${word#--array=} ;; esac; done
number=$((70 + $(wc -l <"$here/calls")))
case $array in
  "") bash "$script" >/dev/null 2>&1 ;;
  *-*) tasks=$(seq ${array/-/ }) ;;
  *) tasks=${array//,/ } ;;
esac
for task in $tasks; do
  if [ "$task" = 2 ] && rm "$here/lose" 2>/dev/null; then continue; fi
  SLURM_ARRAY_TASK_ID=$task bash "$script" >/dev/null 2>&1
done
echo "$number;cluster"
)";
inline constexpr const char* kSqueue =
    "#!/bin/sh\necho 'slurm_load_jobs error: Invalid job id' >&2\nexit 1\n";

/// Puts bin/sbatch and bin/squeue into a folder.
inline void put_slurm(const fs::path& folder) {
  for (const auto& [name, text] : {std::pair{"sbatch", kSbatch}, std::pair{"squeue", kSqueue}}) {
    write(folder / "bin" / name, text);
    fs::permissions(folder / "bin" / name, fs::perms::owner_all);
  }
}

inline Outcome on_slurm(const fs::path& folder, const std::string& arguments) {
  return castaway(folder, arguments, "PATH='" + (folder / "bin").string() + "':\"$PATH\"");
}

}  // namespace castaway::test
