// SPDX-License-Identifier: MIT
#include "suit/suit_options.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <utility>

namespace emulator {

std::vector<std::string> split(const std::string &p_text, char p_separator) {
	std::vector<std::string> parts(1);
	for (const char letter : p_text) {
		if (letter == p_separator) {
			parts.emplace_back();
		} else {
			parts.back() += letter;
		}
	}
	return parts;
}

bool parse_number(const std::string &p_text, double &r_value) {
	if (p_text.empty()) {
		return false;
	}
	char *end = nullptr;
	r_value = p_text.compare(0, 2, "0x") == 0 ? double(std::strtoul(p_text.c_str(), &end, 16))
											  : std::strtod(p_text.c_str(), &end);
	return *end == '\0' && std::isfinite(r_value);
}

std::string SuitOptions::parse(const std::vector<std::string> &p_arguments) {
	for (std::size_t i = 0; i < p_arguments.size(); i++) {
		const std::string &argument = p_arguments[i];
		if (argument == "--") {
			program.assign(p_arguments.begin() + std::ptrdiff_t(i) + 1, p_arguments.end());
			return {};
		}
		if (argument.compare(0, 2, "--") != 0) {
			return "'" + argument + "' is no option: a program to start comes behind '--'";
		}
		const std::size_t equals = argument.find('=');
		const std::string name = argument.substr(2, equals == std::string::npos ? equals : equals - 2);
		const std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
		std::string fault = _set(name, value);
		if (!fault.empty()) {
			return fault;
		}
	}
	return {};
}

std::string SuitOptions::_set(const std::string &p_name, const std::string &p_value) {
	const std::pair<const char *, bool *> flags[] = { { "instant", &is_paced }, { "aligned", &is_aligned },
		{ "mute", &is_mute }, { "hold", &is_held }, { "forbidden", &is_forbidden }, { "real-time", &is_real_time } };
	for (const auto &[name, flag] : flags) {
		if (p_name == name) {
			*flag = p_name != "instant";
			return p_value.empty() ? "" : "--" + p_name + " takes no value";
		}
	}
	std::string fault;
	if (_set_number(p_name, p_value, fault) || _set_text(p_name, p_value)) {
		return fault;
	}
	return _set_special(p_name, p_value);
}

bool SuitOptions::_set_number(const std::string &p_name, const std::string &p_value, std::string &r_fault) {
	double whole_seed = double(seed);
	const struct {
		const char *name;
		int *whole;
		double *real;
		double low;
		double high;
	} numbers[] = {
		{ "sensors", &sensors, nullptr, 1, 40 },
		{ "baud", &baud, nullptr, 4800, 921600 },
		{ "seed", nullptr, &whole_seed, 0, 1e15 },
		{ "heading", nullptr, &heading_deg, 0, 180 },
		{ "noise", nullptr, &noise_deg, 0, 45 },
		{ "drift", nullptr, &drift_deg_min, -360, 360 },
		{ "corrupt", nullptr, &corrupt, 0, 1 },
		{ "drop", nullptr, &drop, 0, 1 },
		{ "unplug-at", nullptr, &unplug_at_s, 0, 1e6 },
		{ "plug-at", nullptr, &plug_at_s, 0, 1e6 },
		{ "error-every", &error_every, nullptr, 1, 1e6 },
		{ "answer-delay", &answer_delay_ms, nullptr, 0, 5000 },
		{ "battery", &battery, nullptr, 0, 255 },
		{ "dead", &dead, nullptr, 1, 40 },
		{ "first-counter", &first_counter, nullptr, 0, 65535 },
		{ "seconds", nullptr, &seconds, 0, 1e6 },
	};
	for (const auto &number : numbers) {
		double value = 0.0;
		if (p_name != number.name) {
			continue;
		}
		const bool is_one = parse_number(p_value, value) && value >= number.low && value <= number.high;
		if (!is_one || (number.whole != nullptr && value != std::floor(value))) {
			std::ostringstream fault;
			fault << "--" << p_name << " is a number from " << number.low << " to " << number.high << ", not '"
				  << p_value << "'";
			r_fault = fault.str();
		} else if (number.whole != nullptr) {
			*number.whole = int(value);
		} else {
			*number.real = value;
		}
		seed = uint64_t(whole_seed);
		return true;
	}
	return false;
}

bool SuitOptions::_set_text(const std::string &p_name, const std::string &p_value) {
	const std::pair<const char *, std::string *> texts[] = { { "devices", &devices }, { "stream", &stream },
		{ "mountings", &mountings }, { "trace", &trace }, { "log", &log }, { "commands", &commands } };
	for (const auto &[name, text] : texts) {
		if (p_name == name) {
			*text = p_value;
			return true;
		}
	}
	return false;
}

std::string SuitOptions::_set_special(const std::string &p_name, const std::string &p_value) {
	double first = 0.0;
	double second = 0.0;
	const std::vector<std::string> pair = split(p_value, ':');
	const bool is_pair = pair.size() == 2 && parse_number(pair[0], first) && parse_number(pair[1], second);
	if (p_name == "limbs") {
		limbs = split(p_value, ',');
		sensors = int(limbs.size());
	} else if (p_name == "swap" && is_pair) {
		swapped_a = int(first);
		swapped_b = int(second);
	} else if (p_name == "lie" && is_pair) {
		liar = int(first);
		lie = int(second);
	} else if (p_name == "bus-power" && (p_value == "on" || p_value == "off")) {
		has_bus_power = p_value == "on";
	} else if (p_name == "master-id" && parse_number("0x" + p_value, first) && first > 0.0 && first < 4294967296.0) {
		master_id = uint32_t(first);
	} else if (p_name == "errors") {
		for (const std::string &one : split(p_value, ',')) {
			const std::vector<std::string> parts = split(one, ':');
			if (parts.size() != 2 || !parse_number("0x" + parts[0], first) || !parse_number("0x" + parts[1], second)) {
				return "--errors takes MESSAGE:CODE in hexadecimal, as d0:21, not '" + one + "'";
			}
			errors[uint8_t(first)] = uint8_t(second);
		}
	} else {
		return "there is no option '--" + p_name + (p_value.empty() ? "'" : "=" + p_value + "'");
	}
	return {};
}

} // namespace emulator
