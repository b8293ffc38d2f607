// SPDX-License-Identifier: MIT
#pragma once

#include "suit/xbus_device.hpp"

namespace emulator {

/// A tracker that is connected to the host itself (MTi): MTData, or MTData2 once a host has chosen items.
class StandAlone final : public XbusDevice {
public:
	StandAlone(Tracker p_tracker, MotionStream p_stream, uint64_t p_seed);

	/// One item of SetOutputConfiguration.
	struct Item {
		uint16_t identifier = 0;
		/// Hz; ALWAYS with every packet.
		uint16_t rate = 0;
	};
	static constexpr uint16_t ALWAYS = 0xFFFF;

	Tracker &tracker() { return _tracker; }
	/// What it sends when nobody has chosen anything: an empty list is MTData.
	void set_items(std::vector<Item> p_items);

protected:
	Answer handle(const xbus::Frame &p_frame, Usec p_now) override;
	bool is_allowed_while_measuring(const xbus::Frame &p_frame) const override;
	uint8_t start_measuring(uint8_t &r_bus_id) override;
	Data sample(double p_motion_s, uint16_t p_counter) override;
	xbus::Message sample_message() const override {
		return _items.empty() ? xbus::Message::MT_DATA : xbus::Message::MT_DATA2;
	}
	bool measures_by_itself() const override { return true; }
	Data configuration() const override;
	void restart() override {}
	int64_t sample_ticks() const override;

private:
	Answer _handle_value(const xbus::Frame &p_frame, Usec p_now);
	Answer _choose_items(const xbus::Frame &p_frame, Usec p_now);
	int _rate() const;

	Tracker _tracker;
	std::vector<Item> _items;
	unsigned _period = 1152;
	unsigned _skip = 0;
	unsigned _location = 0;
};

/// Whether a tracker has this item, in this form.
bool offers_item(uint16_t p_identifier);
/// Writes one item of MTData2 that a tracker has, with identifier and length.
void append_item(Data &r_data, uint16_t p_identifier, const xbus::FullSample &p_sample);

} // namespace emulator
