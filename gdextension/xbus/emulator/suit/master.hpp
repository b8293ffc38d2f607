// SPDX-License-Identifier: MIT
#pragma once

#include "suit/xbus_device.hpp"

namespace emulator {

/// An Xbus Master with its trackers.
class Master final : public XbusDevice {
public:
	Master(uint32_t p_device_id, std::vector<Tracker> p_trackers, MotionStream p_stream, uint64_t p_seed);

	std::vector<Tracker> &trackers() { return _trackers; }
	void set_battery(unsigned p_level) { _battery = p_level; }
	void set_bus_power(bool p_on) { _bus_power = p_on ? 1 : 0; }
	/// A tracker that does not answer any more (from 1; 0: none): measuring fails.
	void set_dead(std::size_t p_bus_id) { _dead = p_bus_id; }

protected:
	Answer handle(const xbus::Frame &p_frame, Usec p_now) override;
	bool is_allowed_while_measuring(const xbus::Frame &p_frame) const override;
	uint8_t start_measuring(uint8_t &r_bus_id) override;
	Data sample(double p_motion_s, uint16_t p_counter) override;
	xbus::Message sample_message() const override { return xbus::Message::MT_DATA; }
	bool measures_by_itself() const override { return false; }
	Data configuration() const override;
	void restart() override;
	int64_t sample_ticks() const override { return int64_t(_period); }

private:
	Answer _handle_own(const xbus::Frame &p_frame, Usec p_now);
	/// Messages that ask for or set one value.
	Answer _handle_value(const xbus::Frame &p_frame, Usec p_now);
	Answer _handle_tracker(const xbus::Frame &p_frame, Usec p_now);
	Answer _init_bus(Usec p_now);
	Answer _set_period(const xbus::Frame &p_frame, Usec p_now);
	Answer _set_mode(const xbus::Frame &p_frame, Tracker &r_tracker, Usec p_now);
	std::size_t _data_size() const;

	std::vector<Tracker> _trackers;
	unsigned _bus_power = 1;
	bool _is_initialised = false;
	unsigned _period = 1152;
	unsigned _battery = 230;
	unsigned _operating_mode = 0;
	unsigned _bluetooth = 0;
	unsigned _sync_mode = 0;
	unsigned _overflow_mode = 0;
	unsigned _buffer_size = 1024;
	std::size_t _dead = 0;
};

/// The data of a Configuration message.
Data configuration_of(uint32_t p_device_id, unsigned p_period, unsigned p_skip, const std::vector<Tracker> &p_trackers,
		bool p_is_behind_master);
/// 20 letters.
Data product_code(const char *p_text);

} // namespace emulator
