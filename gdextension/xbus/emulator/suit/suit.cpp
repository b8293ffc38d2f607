// SPDX-License-Identifier: MIT
#include "suit/suit.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace emulator {
namespace {

constexpr double DEGREE = 0.017453292519943295;
constexpr uint32_t MASTER_ID = 0x00130500;
constexpr uint32_t TRACKER_ID = 0x00302000;
constexpr uint32_t MTI_30_ID = 0x036008A6;
constexpr uint32_t AWINDA_ID = 0x00200417;
constexpr uint16_t PRODUCT_CONVERTER = 0xD38B;
constexpr uint16_t PRODUCT_MTI_30 = 0x0003;
constexpr uint16_t PRODUCT_AWINDA_STATION = 0xD38D;
/// What Xsens' own hosts allow on one master, at most.
constexpr std::size_t MAX_TRACKERS = 20;
/// From the first sample until the wearer begins: a client has found all trackers then and has said what to do.
constexpr Usec REACTION = 1300000;

std::string hexadecimal(uint32_t p_value) {
	std::array<char, 16> text{};
	(void)snprintf(text.data(), text.size(), "%08X", p_value);
	return text.data();
}

} // namespace

Suit::Suit(const SuitOptions &p_options, MotionStream p_stream, std::function<Usec()> p_clock, Log p_log) :
		_options(p_options),
		_stream(std::move(p_stream)),
		_clock(std::move(p_clock)),
		_log(std::move(p_log)),
		_random(p_options.seed) {
	std::vector<Tracker> trackers;
	_error = _make_trackers(trackers);
	if (_error.empty()) {
		_error = _make_all(std::move(trackers));
	}
}

std::string Suit::_make_trackers(std::vector<Tracker> &r_trackers) {
	r_trackers.resize(std::size_t(_options.sensors));
	for (std::size_t i = 0; i < r_trackers.size(); i++) {
		Tracker &tracker = r_trackers[i];
		tracker.device_id = TRACKER_ID + uint32_t(i) + 1;
		tracker.limb = i % _stream.limb_count();
		if (!_options.limbs.empty()) {
			std::size_t limb = 0;
			while (limb < _stream.limb_count() && _stream.limb_name(limb) != _options.limbs[i]) {
				limb++;
			}
			if (limb == _stream.limb_count()) {
				return "the motion has no limb '" + _options.limbs[i] + "'";
			}
			tracker.limb = limb;
		}
		if (!_options.is_aligned) {
			tracker.mounting = Mounting::random(_random, _options.heading_deg * DEGREE);
		}
		tracker.mounting.noise = _options.noise_deg * DEGREE;
		tracker.mounting.drift = _random.between(-1.0, 1.0) * _options.drift_deg_min * DEGREE / 60.0;
	}
	const auto count = int(r_trackers.size());
	if (std::max({ _options.swapped_a, _options.swapped_b, _options.liar }) > count) {
		return "there are only " + std::to_string(count) + " sensors";
	}
	if (_options.swapped_a > 0 && _options.swapped_b > 0) {
		std::swap(r_trackers[std::size_t(_options.swapped_a) - 1].limb,
				r_trackers[std::size_t(_options.swapped_b) - 1].limb);
	}
	if (_options.liar > 0) {
		r_trackers[std::size_t(_options.liar) - 1].length_fault = _options.lie;
	}
	return _options.mountings.empty() ? "" : _read_mountings(r_trackers);
}

std::string Suit::_read_mountings(std::vector<Tracker> &r_trackers) const {
	std::ifstream file(_options.mountings);
	std::string line;
	for (Tracker &tracker : r_trackers) {
		float w = 1.0F;
		kinematics::Quat turn;
		double heading = 0.0;
		if (!std::getline(file, line) || !(std::istringstream(line) >> w >> turn.x >> turn.y >> turn.z >> heading)) {
			return _options.mountings + " needs a line 'w x y z degrees' for each sensor";
		}
		turn.w = w;
		if (!turn.is_finite() || turn.dot(turn) < 1e-6F) {
			return _options.mountings + " holds what is no rotation: '" + line + "'";
		}
		tracker.mounting.rotation = turn.normalized();
		tracker.mounting.heading = heading * DEGREE;
	}
	return {};
}

std::string Suit::_make_all(std::vector<Tracker> p_trackers) {
	for (const std::string &kind : split(_options.devices, ',')) {
		if (kind == "two-masters" || kind == "two-native-masters") {
			const std::string chip = kind == "two-masters" ? "ftdi" : "native";
			const auto half = p_trackers.begin() + ptrdiff_t((p_trackers.size() + 1) / 2);
			std::string fault = _make(chip, { p_trackers.begin(), half });
			fault = fault.empty() ? _make(chip, { half, p_trackers.end() }) : fault;
			if (!fault.empty()) {
				return fault;
			}
		} else if (std::string fault = _make(kind, p_trackers); !fault.empty()) {
			return fault;
		}
	}
	return {};
}

std::string Suit::_make(const std::string &p_kind, std::vector<Tracker> p_trackers) {
	const uint64_t seed = _options.seed * 100 + _devices.size();
	const auto number = uint32_t(_devices.size());
	if (p_kind == "mti" || p_kind == "mti-ftdi") {
		Tracker tracker = p_trackers.front();
		tracker.device_id = MTI_30_ID + number;
		auto device = std::make_unique<StandAlone>(tracker, _stream, seed);
		device->set_items({ { 0x1020, StandAlone::ALWAYS }, { 0x2010, 100 }, { 0x8020, 100 }, { 0x4020, 100 } });
		_add(std::move(device), p_kind == "mti" ? "native" : "ftdi",
				p_kind == "mti" ? PRODUCT_MTI_30 : PRODUCT_CONVERTER);
		return {};
	}
	if (p_kind == "awinda") {
		auto device = std::make_unique<Master>(AWINDA_ID, std::vector<Tracker>(), _stream, seed);
		_add(std::move(device), "ftdi", PRODUCT_AWINDA_STATION);
		return {};
	}
	if (p_kind != "ftdi" && p_kind != "ftdi-fast" && p_kind != "native") {
		return "there is no device '" + p_kind +
				"': --devices takes ftdi, ftdi-fast, native, two-masters, two-native-masters, mti, mti-ftdi, awinda";
	}
	if (p_trackers.size() > MAX_TRACKERS) {
		return "a master has at most " + std::to_string(MAX_TRACKERS) + " sensors: use --devices=two-masters";
	}
	auto device = std::make_unique<Master>(
			(_options.master_id != 0 ? _options.master_id : MASTER_ID) + number, std::move(p_trackers), _stream, seed);
	device->set_bus_power(_options.has_bus_power);
	device->set_battery(unsigned(_options.battery));
	device->set_dead(std::size_t(_options.dead));
	_add(std::move(device), p_kind, p_kind == "native" ? PRODUCT_MTI_30 : PRODUCT_CONVERTER);
	return {};
}

void Suit::_add(std::unique_ptr<XbusDevice> p_device, const std::string &p_kind, uint16_t p_product) {
	const std::size_t index = _devices.size() + 1;
	SuitDevice made;
	made.device = std::move(p_device);
	made.master = dynamic_cast<Master *>(made.device.get());
	made.device->set_baud(uint32_t(_options.baud));
	made.device->set_first_counter(uint16_t(_options.first_counter));
	made.device->faults.errors = _options.errors;
	made.device->faults.error_every = _options.error_every;
	made.device->faults.answer_delay = Usec(_options.answer_delay_ms) * 1000;
	made.device->faults.is_mute = _options.is_mute;
	made.device->set_log([this, index](Usec p_now, const std::string &p_text) { _log(p_now, index, p_text); });
	made.device->set_on_measuring([this](Usec p_now) {
		if (_waits) {
			_move("go", 0.0, p_now + REACTION);
		}
	});
	const std::string serial = hexadecimal(made.device->device_id());
	if (p_kind == "native") {
		auto chip = std::make_unique<NativeChip>(p_product, serial, _options.seed + index, *made.device);
		made.native = chip.get();
		made.chip = std::move(chip);
	} else {
		ChipOptions options;
		options.product = p_product;
		options.serial = serial;
		options.is_fast = p_kind == "ftdi-fast";
		options.is_paced = _options.is_paced;
		options.seed = _options.seed + index;
		auto chip = std::make_unique<FtdiChip>(options, *made.device);
		made.ftdi = chip.get();
		made.chip = std::move(chip);
	}
	made.line().faults = { _options.corrupt, _options.drop };
	const auto log = [this, index](const std::string &p_text) { _log(_clock(), index, p_text); };
	made.port = std::make_unique<UsbPort>(*made.chip, log);
	_devices.push_back(std::move(made));
}

void Suit::advance(Usec p_now) {
	for (SuitDevice &one : _devices) {
		one.port->advance(p_now);
	}
}

Usec Suit::next_event() const {
	Usec next = NEVER;
	for (const SuitDevice &one : _devices) {
		next = std::min(next, one.port->next_event());
	}
	return next;
}

void Suit::begin(Usec p_now) {
	_waits = !_options.is_held;
	for (SuitDevice &one : _devices) {
		one.device->set_motion(0.0, false, p_now);
	}
}

bool Suit::_move(const std::string &p_name, double p_value, Usec p_since) {
	double time = _devices.front().device->motion_time(p_since);
	if (p_name == "calibrate") {
		time = 0.0;
	} else if (p_name == "clip") {
		time = _stream.lead_in_s();
	} else if (p_name == "motion") {
		time = std::max(p_value, 0.0);
	} else if (p_name != "hold" && p_name != "go") {
		return false;
	}
	_waits = false;
	for (SuitDevice &one : _devices) {
		one.device->set_motion(time, p_name != "hold", p_since);
	}
	return true;
}

bool Suit::_disturb(SuitDevice &r_device, const std::string &p_name, double p_value, Usec p_now) {
	if (p_name == "corrupt") {
		r_device.line().faults.corrupt = std::clamp(p_value, 0.0, 1.0);
	} else if (p_name == "drop") {
		r_device.line().faults.drop = std::clamp(p_value, 0.0, 1.0);
	} else if (p_name == "error") {
		r_device.device->send_error(uint8_t(p_value), p_now);
	} else if (p_name == "mute" || p_name == "speak") {
		r_device.device->faults.is_mute = p_name == "mute";
	} else if (p_name == "freeze" || p_name == "thaw") {
		r_device.device->faults.is_frozen = p_name == "freeze";
	} else if (p_name == "stall") {
		r_device.ftdi != nullptr ? r_device.ftdi->halt() : r_device.native->halt();
	} else if (p_name == "battery") {
		if (r_device.master != nullptr) {
			r_device.master->set_battery(unsigned(std::clamp(p_value, 0.0, 255.0)));
		}
	} else {
		return false;
	}
	return true;
}

std::string Suit::command(const std::string &p_line, Usec p_now, bool &r_is_known) {
	std::istringstream words(p_line);
	std::string name;
	std::string text;
	words >> name >> text;
	double value = 0.0;
	const bool has_value = parse_number(name == "error" ? "0x" + text : text, value);
	const char *with_value[] = { "corrupt", "drop", "error", "battery", "motion" };
	const auto is_it = [&name](const char *p_one) { return name == p_one; };
	r_is_known = true;
	if (!has_value && std::any_of(std::begin(with_value), std::end(with_value), is_it)) {
		return "'" + name + "' needs a number";
	}
	if (_move(name, value, p_now)) {
		return {};
	}
	for (SuitDevice &one : _devices) {
		r_is_known = _disturb(one, name, value, p_now) && r_is_known;
	}
	return {};
}

} // namespace emulator
