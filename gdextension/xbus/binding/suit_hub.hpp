// SPDX-License-Identifier: MIT
#pragma once

#include "raw_player.hpp"
#include "raw_recorder.hpp"
#include "suit_device.hpp"
#include "suit_frame.hpp"
#include "suit_message.hpp"

#include <recording/taps.hpp>
#include <usb/hub.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <memory>

namespace godot {

/// All suits on this machine's USB ports. Documented in doc_classes/SuitHub.xml.
class SuitHub : public RefCounted {
	GDCLASS(SuitHub, RefCounted)

public:
	String start(double p_rate_hz);
	void stop();
	bool is_running() const { return _hub != nullptr; }
	void set_recorder(const Ref<RawRecorder> &p_recorder);
	void play(const Ref<RawPlayer> &p_player);
	TypedArray<SuitDevice> get_devices() const;
	TypedArray<SuitMessage> take_messages();
	TypedArray<SuitFrame> take_frames(int64_t p_device);

protected:
	static void _bind_methods();

private:
	/// Outlives the hub, which calls it.
	recording::BusTap _tap;
	std::unique_ptr<usb::Hub> _hub;
	Ref<RawPlayer> _player;
	xbus::SuitFrame _frame;
};

} // namespace godot
