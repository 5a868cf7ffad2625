/// This process's own command line, to be given to other processes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::testbed {

/// The words of this process's command line, without the program.
std::vector<std::string> own_words();

/// The words without those that say how a batch is made or shown: -j, --shard, --collect, those of
/// Slurm, --json, --rank, --metric.
std::vector<std::string> shared_words(const std::vector<std::string>& words);

/// The shared words without those that name the folder and what is done again: what a batch is.
std::vector<std::string> asked_words(const std::vector<std::string>& words);

/// The words of `run --seeds` as a line for a shell that plays one of its seeds into folder "look".
std::string command_of_seed(const std::vector<std::string>& words, std::uint64_t seed);

/// Hash of all files that words name, also in `--option=FILE`, and of those in named folders.
std::string hash_of_named_files(const std::vector<std::string>& words);

}  // namespace castaway::testbed
