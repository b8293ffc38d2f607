// SPDX-License-Identifier: MIT
// Says what a recording of an Xbus holds: xbus_decode FILE [--json] [options].
#include "report.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string_view>

namespace {

constexpr const char *HELP =
		"xbus-decode FILE [--json] [options]\n"
		"\n"
		"Says what a recording of an Xbus holds: raw bytes as they came (also with the status bytes of an\n"
		"FTDI chip left in), hexadecimal text, or a recording of Dismount's (of the bus that said the\n"
		"most).\n"
		"\n"
		"  --json            everything, each message decoded, as one JSON object (docs/xbus.md)\n"
		"  --mode=N          output mode of MTData, if no message in the recording has it\n"
		"  --settings=N      output settings of MTData\n"
		"  --master          MTData comes from a master\n"
		"  --devices=N       trackers behind that master\n"
		"\n"
		"Numbers may be given as 0x6. Exit code: 0, or 1 if no message was found, 2 if the file or\n"
		"an option is wrong.\n";

struct Options {
	std::string file;
	bool json = false;
	bool help = false;
	FormatOptions format;
};

bool number(std::string_view p_text, uint64_t p_least, uint64_t p_most, uint64_t &r_number) {
	const std::string text(p_text);
	char *end = nullptr;
	r_number = std::strtoull(text.c_str(), &end, 0);
	return !text.empty() && text[0] != '-' && *end == '\0' && r_number >= p_least && r_number <= p_most;
}

/// One option; false if it is wrong.
bool take(std::string_view p_argument, Options &r_options) {
	const auto value_of = [&](std::string_view p_name, std::string_view &r_value) {
		const bool is = p_argument.substr(0, p_name.size()) == p_name;
		r_value = is ? p_argument.substr(p_name.size()) : std::string_view();
		return is;
	};
	std::string_view text;
	uint64_t value = 0;
	if (p_argument == "--json") {
		r_options.json = true;
	} else if (p_argument == "--master") {
		r_options.format.is_master = true;
	} else if (value_of("--mode=", text) && number(text, 1, 0xFFFF, value)) {
		r_options.format.mode = uint16_t(value);
	} else if (value_of("--settings=", text) && number(text, 0, 0xFFFFFFFF, value)) {
		r_options.format.settings = uint32_t(value);
	} else if (value_of("--devices=", text) && number(text, 1, xbus::MAX_DEVICES, value)) {
		r_options.format.devices = value;
		r_options.format.is_master = true;
	} else if (p_argument.substr(0, 2) != "--" && r_options.file.empty()) {
		r_options.file = p_argument;
	} else {
		return false;
	}
	return true;
}

bool read_options(int p_count, char **p_arguments, Options &r_options) {
	for (int i = 1; i < p_count; i++) {
		const std::string_view argument = p_arguments[i];
		if (argument == "--help" || argument == "-h") {
			r_options.help = true;
			return true;
		}
		if (!take(argument, r_options)) {
			std::fprintf(stderr, "xbus-decode: '%s' is wrong or one too many: see --help.\n", p_arguments[i]);
			return false;
		}
	}
	const FormatOptions &format = r_options.format;
	if (r_options.file.empty()) {
		std::fprintf(stderr, "xbus-decode: which file? See --help.\n");
		return false;
	}
	const bool valid = !format.mode || xbus::OutputFormat{ *format.mode, format.settings }.is_valid();
	if (!valid || (!format.mode && (format.is_master || format.settings != 0))) {
		std::fprintf(stderr, "xbus-decode: %s\n",
				valid ? "--settings, --master and --devices need --mode."
					  : "no device knows this mode with these settings.");
		return false;
	}
	return true;
}

int run(int p_count, char **p_arguments) {
	Options options;
	if (!read_options(p_count, p_arguments, options)) {
		return 2;
	}
	if (options.help) {
		std::fputs(HELP, stdout);
		return 0;
	}
	Recording recording;
	std::string fault;
	if (!read_recording(options.file, recording, fault)) {
		std::fprintf(stderr, "xbus-decode: %s\n", fault.c_str());
		return 2;
	}
	const Analysis analysis = analyse(recording, options.format);
	(options.json ? write_json_report : write_text_report)(recording, analysis, stdout);
	if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
		std::fprintf(stderr, "xbus-decode: what was found could not be written: %s.\n", std::strerror(errno));
		return 2;
	}
	if (analysis.entries.empty()) {
		std::fprintf(stderr, "xbus-decode: %s holds no Xbus message.\n", options.file.c_str());
		return 1;
	}
	return 0;
}

} // namespace

int main(int p_count, char **p_arguments) {
	try {
		return run(p_count, p_arguments);
	} catch (const std::exception &problem) {
		std::fprintf(stderr, "xbus-decode: %s.\n", problem.what());
		return 2;
	}
}
