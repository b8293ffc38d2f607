// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "private_file.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace test_private_file {

using host::PrivateFile;
using Outcome = PrivateFile::Outcome;

namespace {

/// A folder that is gone after the test.
class Folder {
public:
	Folder() {
		std::string name = (std::filesystem::temp_directory_path() / "private_file_XXXXXX").string();
		_root = mkdtemp(name.data());
	}
	~Folder() { std::filesystem::remove_all(_root); }
	Folder(const Folder &) = delete;
	Folder &operator=(const Folder &) = delete;
	std::string path(const char *p_name) const { return _root + "/" + p_name; }

private:
	std::string _root;
};

unsigned mode_of(const std::string &p_path) {
	struct stat status = {};
	stat(p_path.c_str(), &status);
	return status.st_mode & 0777U;
}

const std::vector<uint8_t> BYTES = { 1, 0, 255, 7 };

} // namespace

TEST(only_the_owner_can_read_it) {
	const Folder folder;
	umask(0);
	PrivateFile file;
	CHECK(file.open(folder.path("new")) == Outcome::OPENED);
	CHECK(mode_of(folder.path("new")) == 0600U);
	file.close();
	chmod(folder.path("new").c_str(), 0666);
	CHECK(file.open(folder.path("new")) == Outcome::OPENED);
	CHECK(mode_of(folder.path("new")) == 0600U);
}

TEST(what_is_written_replaces_what_was_there) {
	const Folder folder;
	PrivateFile file;
	CHECK(file.read().empty() && !file.write(BYTES) && !file.remove());
	CHECK(file.open(folder.path("a")) == Outcome::OPENED);
	CHECK(file.read().empty());
	CHECK(file.write(std::vector<uint8_t>(100, 9)) && file.write(BYTES));
	file.close();
	CHECK(file.open(folder.path("a")) == Outcome::OPENED);
	CHECK(file.read() == BYTES);
	CHECK(file.write(std::vector<uint8_t>(PrivateFile::MAX_SIZE + 1, 1)));
	CHECK(file.read().size() == PrivateFile::MAX_SIZE);
	CHECK(file.remove());
	CHECK(!std::filesystem::exists(folder.path("a")));
}

TEST(one_at_a_time_has_it) {
	const Folder folder;
	PrivateFile first;
	PrivateFile second;
	CHECK(first.open(folder.path("a")) == Outcome::OPENED);
	CHECK(second.open(folder.path("a")) == Outcome::BUSY);
	first.close();
	CHECK(second.open(folder.path("a")) == Outcome::OPENED);
}

TEST(a_killed_process_leaves_it_unlocked) {
	const Folder folder;
	int ready[2] = {};
	CHECK(pipe(ready) == 0);
	const pid_t child = fork();
	if (child == 0) {
		PrivateFile file;
		const bool held = file.open(folder.path("a")) == Outcome::OPENED && file.write(BYTES);
		const char said = held ? 'y' : 'n';
		(void)!write(ready[1], &said, 1);
		for (;;) {
			pause();
		}
	}
	char said = 0;
	CHECK(read(ready[0], &said, 1) == 1 && said == 'y');
	PrivateFile file;
	CHECK(file.open(folder.path("a")) == Outcome::BUSY);
	kill(child, SIGKILL);
	waitpid(child, nullptr, 0);
	CHECK(file.open(folder.path("a")) == Outcome::OPENED);
	CHECK(file.read() == BYTES);
}

TEST(links_folders_and_missing_folders_are_refused) {
	const Folder folder;
	PrivateFile file;
	std::filesystem::create_symlink(folder.path("target"), folder.path("link"));
	CHECK(file.open(folder.path("link")) == Outcome::FOREIGN);
	CHECK(!std::filesystem::exists(folder.path("target")));
	CHECK(mkfifo(folder.path("fifo").c_str(), 0600) == 0);
	CHECK(file.open(folder.path("fifo")) == Outcome::FOREIGN);
	CHECK(file.open(folder.path(".")) == Outcome::FAILED);
	CHECK(file.open(folder.path("none/a")) == Outcome::FAILED);
}

} // namespace test_private_file
