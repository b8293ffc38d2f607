// SPDX-License-Identifier: MIT
// Driver: the frame that the motion happens in, and what carries it.
#include "driver.hpp"

namespace ragdoll {

namespace {

/// Whether a frame is that of the world.
bool is_nowhere(const Quat &p_orientation, const Vec3 &p_origin) {
	return p_origin.length() == 0.0f && p_orientation.w == 1.0f;
}

} // namespace

void Driver::MotionFrame::apply(Pose &r_pose) const {
	if (is_identity) {
		return;
	}
	for (Quat &limb : r_pose.orientations) {
		limb = orientation * limb;
	}
	r_pose.root = orientation.rotate(r_pose.root) + origin;
}

void Driver::set_frame(const Quat &p_orientation, const Vec3 &p_origin) {
	_frame_next = { p_orientation, p_origin, is_nowhere(p_orientation, p_origin) };
	_is_frame_set = true;
}

void Driver::MotionFrame::save(ArchiveWriter &p_archive) const {
	p_archive.put(orientation);
	p_archive.put(origin);
}

bool Driver::MotionFrame::restore(ArchiveReader &p_archive) {
	if (!p_archive.get(orientation) || !p_archive.get(origin) || !orientation.is_finite() || !origin.is_finite()) {
		return false;
	}
	is_identity = is_nowhere(orientation, origin);
	return true;
}

Driver::MotionFrame Driver::MotionFrame::moved(const Ride &p_ride) const {
	return { (p_ride.turn * orientation).normalized(), p_ride.apply(origin), false };
}

void Driver::ride(RigState &r_state, float p_delta_s) {
	if (_is_frame_set || ground == nullptr) {
		// Who is in a seat goes where that goes.
		_carrier.clear();
		_frame_base = _frame_next;
		_is_frame_set = false;
	} else {
		_carrier.advance(_rig, _contacts, r_state, *ground, p_delta_s);
		// Others are drawn back to where they stood.
		if (!is_tethered(root_mode) && _carrier.get_spiral().length() > 0.0f) {
			for (Vec3 &centre : r_state.centres) {
				centre = centre - _carrier.get_spiral();
			}
			r_state.root = r_state.root - _carrier.get_spiral();
			_commands.must_put = true;
		}
		_frame_base = _carrier.get_past().moves ? _frame_base.moved(_carrier.get_past()) : _frame_base;
		_frame_now = _frame_base;
		_frame_next = _carrier.get_ahead().moves ? _frame_base.moved(_carrier.get_ahead()) : _frame_base;
	}
	_frame_turn = _frame_next.orientation * _frame_now.orientation.inverse();
	_frame_shift = _frame_next.origin - _frame_turn.rotate(_frame_now.origin);
}

void Driver::clear_motion() {
	_frame_now = _frame_next; // What comes begins in the frame that is set.
	_stream.clear();
	_meter.forget_waiting();
	_alive = NEVER;
}

} // namespace ragdoll
