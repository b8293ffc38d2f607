// SPDX-License-Identifier: MIT
#pragma once

#include "force_effects.hpp"

namespace cueing {

/// An open device. All calls may take as long as its driver takes: milliseconds on USB.
class ForceDevice {
public:
	ForceDevice() = default;
	~ForceDevice() { close(); }
	ForceDevice(const ForceDevice &) = delete;
	ForceDevice &operator=(const ForceDevice &) = delete;

	/// Opens it without a spring of its own. Returns what is wrong and what helps, or an empty text.
	std::string open(const std::string &p_path);
	/// Takes its effects away.
	void close();
	bool is_open() const { return _descriptor >= 0; }
	const ForceDeviceInfo &info() const { return _info; }
	/// How many effects it has room for.
	int room() const { return _room; }
	/// Makes it do this. Sends only what has changed. False: it is gone, and was closed.
	bool apply(const WheelForces &p_forces);
	/// Strength of all effects, 0 to 1.
	bool set_gain(double p_gain);
	/// What does not work, such as effects that there is no room for; empty if all does.
	const std::string &note() const { return _note; }

private:
	struct Slot {
		bool is_left_out = false;
		bool is_uploaded = false;
		bool is_playing = false;
		ff_effect effect{};
	};

	void read_capabilities();
	bool apply_one(ForceKind p_kind, const WheelForces &p_forces);
	bool upload(ForceKind p_kind, const ff_effect &p_effect);
	bool write_event(uint16_t p_code, int32_t p_value);
	bool has_gone(int p_error);

	int _descriptor = -1;
	ForceDeviceInfo _info;
	int _room = 0;
	bool _has_gain = false;
	std::array<Slot, FORCE_KINDS> _slots;
	std::string _note;
};

} // namespace cueing
