// SPDX-License-Identifier: MIT
// Recordings: written without waiting, read whatever became of the file.
#include <count_allocations.hpp>

#include "recording/reader.hpp"
#include "recording/recorder.hpp"

#include <check.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <random>

using namespace recording;

namespace {

using Bytes = std::vector<uint8_t>;

/// A folder that goes away with the test.
class Folder {
public:
	Folder() {
		std::string pattern = "/tmp/dismount_recording_XXXXXX";
		_path = mkdtemp(pattern.data());
	}
	Folder(const Folder &) = delete;
	Folder &operator=(const Folder &) = delete;
	~Folder() {
		unlink(file().c_str());
		rmdir(_path.c_str());
	}
	std::string file() const { return _path + "/raw"; }

private:
	std::string _path;
};

Bytes payload(uint32_t p_number) {
	std::mt19937 random(p_number);
	Bytes bytes(random() % 60);
	for (uint8_t &byte : bytes) {
		byte = uint8_t(random());
	}
	return bytes;
}

/// A small recording of both kinds.
void write(Recorder &r_recorder, uint32_t p_records) {
	const int bus = r_recorder.add_stream("kind=bus\nserial=00300123\n", 5);
	const int people = r_recorder.add_stream("kind=mvn\nsender=10.0.0.1:99\n", 6);
	for (uint32_t number = 0; number < p_records; ++number) {
		const Bytes bytes = payload(number);
		const Kind kind = number % 3 == 2 ? Kind::DATAGRAM : (number % 3 == 1 ? Kind::BUS_OUT : Kind::BUS_IN);
		r_recorder.add(kind, kind == Kind::DATAGRAM ? people : bus, bytes.data(), bytes.size(), 1000 + number);
	}
}

Bytes read_file(const std::string &p_path) {
	Bytes bytes;
	std::FILE *file = std::fopen(p_path.c_str(), "rb");
	for (int byte = std::fgetc(file); byte != EOF; byte = std::fgetc(file)) {
		bytes.push_back(uint8_t(byte));
	}
	std::fclose(file);
	return bytes;
}

Bytes recorded(uint32_t p_records) {
	const Folder folder;
	Recorder recorder;
	CHECK(recorder.open(folder.file(), "by=test\n").empty());
	write(recorder, p_records);
	recorder.close();
	return read_file(folder.file());
}

/// The numbers of the records of a file, in their order; -1 for one that is not as it was written.
std::vector<int> numbers_of(Reader &r_reader) {
	std::vector<int> numbers;
	Record record;
	while (r_reader.next(record)) {
		if (record.time_usec >= 1000 && record.kind != Kind::END) {
			const auto number = uint32_t(record.time_usec - 1000);
			const Bytes expected = payload(number);
			const bool is_same =
					record.size == expected.size() && std::equal(expected.begin(), expected.end(), record.payload);
			numbers.push_back(is_same ? int(number) : -1);
		}
	}
	return numbers;
}

bool is_run(const std::vector<int> &p_numbers, int p_first, std::size_t p_begin, std::size_t p_end) {
	for (std::size_t at = p_begin; at < p_end; ++at) {
		if (p_numbers[at] != p_first + int(at - p_begin)) {
			return false;
		}
	}
	return true;
}

} // namespace

TEST(what_was_recorded_is_read) {
	Reader reader;
	CHECK(reader.open(recorded(50)).empty());
	Record record;
	CHECK(reader.next(record) && record.kind == Kind::FILE_HEAD && about(record, "by") == "test");
	CHECK(reader.next(record) && record.kind == Kind::STREAM && about(record, "serial") == "00300123");
	CHECK(reader.next(record) && record.stream == 1 && about(record, "sender") == "10.0.0.1:99");
	CHECK(about(record, "send").empty() && about(record, "99").empty());
	const std::vector<int> numbers = numbers_of(reader);
	CHECK(numbers.size() == 50 && is_run(numbers, 0, 0, 50));
	CHECK(reader.stats().has_end && reader.stats().damaged_bytes == 0 && reader.stats().cut_bytes == 0);
}

TEST(a_recording_is_never_overwritten) {
	const Folder folder;
	Recorder recorder;
	CHECK(recorder.open(folder.file(), "").empty());
	Recorder other;
	CHECK(other.open(folder.file(), "").find("never overwritten") != std::string::npos);
	CHECK(other.open("/nowhere/raw", "").find("/nowhere/raw") != std::string::npos);
	recorder.close();
}

TEST(a_cut_anywhere_leaves_all_in_front_of_it) {
	const Bytes whole = recorded(30);
	std::size_t before = 0;
	for (std::size_t size = MAGIC.size(); size <= whole.size(); ++size) {
		Reader reader;
		CHECK(reader.open(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size))).empty());
		const std::vector<int> numbers = numbers_of(reader);
		CHECK(is_run(numbers, 0, 0, numbers.size()));
		CHECK(numbers.size() >= before && numbers.size() <= before + 1);
		before = numbers.size();
		const ReaderStats &stats = reader.stats();
		CHECK(stats.damaged_bytes == 0 && stats.has_end == (size == whole.size()));
		// Every byte is of a record or cut off.
		CHECK(MAGIC.size() + stats.records * HEAD_SIZE + stats.payload_bytes + stats.cut_bytes == size);
	}
	CHECK(before == 30);
}

TEST(a_wrong_byte_costs_one_record) {
	const Bytes whole = recorded(30);
	for (std::size_t at = MAGIC.size(); at < whole.size(); ++at) {
		Bytes bytes = whole;
		bytes[at] ^= uint8_t(1U << (at % 8));
		Reader reader;
		CHECK(reader.open(bytes).empty());
		const std::vector<int> numbers = numbers_of(reader);
		CHECK(numbers.size() + 1 >= 30);
		CHECK(std::find(numbers.begin(), numbers.end(), -1) == numbers.end());
		CHECK(std::is_sorted(numbers.begin(), numbers.end()));
		CHECK(reader.stats().damaged_bytes + reader.stats().cut_bytes > 0);
	}
}

TEST(stretches_that_are_gone_or_overwritten_cost_what_is_in_them) {
	const Bytes whole = recorded(200);
	std::mt19937 random(4);
	for (int round = 0; round < 300; ++round) {
		Bytes bytes = whole;
		const auto from = std::ptrdiff_t(MAGIC.size() + random() % (bytes.size() - 200));
		const auto size = std::ptrdiff_t(random() % 150);
		if (round % 2 == 0) {
			bytes.erase(bytes.begin() + from, bytes.begin() + from + size);
		} else {
			std::generate(bytes.begin() + from, bytes.begin() + from + size, [&]() { return uint8_t(random()); });
		}
		Reader reader;
		CHECK(reader.open(bytes).empty());
		const std::vector<int> numbers = numbers_of(reader);
		CHECK(numbers.size() >= 190 && std::find(numbers.begin(), numbers.end(), -1) == numbers.end());
		CHECK(std::is_sorted(numbers.begin(), numbers.end()));
	}
}

TEST(files_that_are_none_are_refused) {
	Reader reader;
	Record record;
	CHECK(!reader.open({}).empty());
	CHECK(!reader.next(record));
	CHECK(!reader.open(Bytes(1000, 0xFA)).empty());
	CHECK(reader.open_file("/nowhere").find("/nowhere") != std::string::npos);
	CHECK(reader.open_file("/tmp").find("no file") != std::string::npos);
}

TEST(made_up_heads_take_no_memory_and_little_time) {
	// Heads that are right and announce 64 K behind them, one in the other, thousands of times.
	Bytes bytes(MAGIC.begin(), MAGIC.end());
	std::array<uint8_t, HEAD_SIZE> head{};
	put_head(Kind::BUS_IN, 0, 1, nullptr, 0, head.data());
	put_little(MAX_PAYLOAD, 4, head.data() + 4);
	put_little(crc32(head.data(), 24), 4, head.data() + 24);
	for (int number = 0; number < 100000; ++number) {
		bytes.insert(bytes.end(), head.begin(), head.end());
	}
	Reader reader;
	CHECK(reader.open(bytes).empty());
	Record record;
	CHECK(!reader.next(record));
	// And lengths beyond everything.
	put_little(0xFFFFFFFF, 4, head.data() + 4);
	put_little(crc32(head.data(), 24), 4, head.data() + 24);
	bytes.assign(MAGIC.begin(), MAGIC.end());
	bytes.insert(bytes.end(), head.begin(), head.end());
	CHECK(reader.open(bytes).empty());
	CHECK(!reader.next(record));
}

TEST(a_killed_process_leaves_all_that_was_written) {
	for (int round = 0; round < 6; ++round) {
		const Folder folder;
		const pid_t child = fork();
		if (child == 0) {
			Recorder recorder;
			recorder.open(folder.file(), "");
			const int stream = recorder.add_stream("kind=bus\n", 1);
			for (uint32_t number = 0;; ++number) {
				const Bytes bytes = payload(number);
				recorder.add(Kind::BUS_IN, stream, bytes.data(), bytes.size(), 1000 + number);
				usleep(number % 64 == 0 ? 1000 : 0);
			}
		}
		// Until something is there, and then some more.
		struct stat status{};
		for (int wait = 0; wait < 10000 && status.st_size < 20000 * (round + 1); ++wait) {
			usleep(1000);
			stat(folder.file().c_str(), &status);
		}
		kill(child, SIGKILL);
		waitpid(child, nullptr, 0);
		Reader reader;
		CHECK(reader.open_file(folder.file()).empty());
		const std::vector<int> numbers = numbers_of(reader);
		CHECK(numbers.size() > 100 && is_run(numbers, 0, 0, numbers.size()));
		CHECK(!reader.stats().has_end && reader.stats().damaged_bytes == 0 && reader.stats().lost == 0);
	}
}

TEST(a_slow_disk_never_stops_the_bus_and_what_is_lost_is_noted) {
	std::array<int, 2> ends{};
	CHECK(pipe(ends.data()) == 0);
	Recorder recorder(64U << 10U);
	recorder.open_descriptor(ends[1], "");
	const int stream = recorder.add_stream("kind=bus\n", 1);
	std::vector<Bytes> payloads;
	payloads.reserve(20000);
	for (uint32_t number = 0; number < 20000; ++number) {
		payloads.push_back(payload(number));
	}
	const int before = allocations;
	for (uint32_t number = 0; number < 20000; ++number) {
		// Nobody reads the pipe: this would stand still if it waited for it.
		recorder.add(Kind::BUS_IN, stream, payloads[number].data(), payloads[number].size(), 1000 + number);
	}
	CHECK(allocations == before);
	const uint64_t lost = recorder.stats().lost;
	CHECK(lost > 1000);
	Bytes bytes;
	std::thread drain([&]() {
		std::array<uint8_t, 4096> block{};
		for (ssize_t count = 1; count > 0;) {
			count = ::read(ends[0], block.data(), block.size());
			bytes.insert(bytes.end(), block.begin(), block.begin() + std::max<ssize_t>(count, 0));
		}
	});
	recorder.close();
	drain.join();
	::close(ends[0]);
	Reader reader;
	CHECK(reader.open(bytes).empty());
	const std::vector<int> numbers = numbers_of(reader);
	CHECK(reader.stats().lost == lost && reader.stats().has_end);
	// Those that note a loss have no number of their own.
	const auto good = std::count_if(numbers.begin(), numbers.end(), [](int p_number) { return p_number >= 0; });
	CHECK(uint64_t(good) + lost == 20000);
}

TEST(a_full_disk_is_reported_and_stops_nothing) {
	const int full = open("/dev/full", O_WRONLY);
	CHECK(full >= 0);
	Recorder recorder;
	recorder.open_descriptor(full, "");
	const Bytes bytes(100, 1);
	std::string fault;
	for (int wait = 0; wait < 5000 && fault.empty(); ++wait) {
		recorder.add(Kind::BUS_IN, 0, bytes.data(), bytes.size(), 1);
		usleep(1000);
		fault = recorder.stats().fault;
	}
	CHECK(fault.find("can't be written") != std::string::npos);
	const uint64_t lost = recorder.stats().lost;
	recorder.add(Kind::BUS_IN, 0, bytes.data(), bytes.size(), 1);
	CHECK(recorder.stats().lost == lost + 1);
	recorder.close();
}

TEST_MAIN()
