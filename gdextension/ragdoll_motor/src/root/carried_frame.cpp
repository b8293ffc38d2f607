// SPDX-License-Identifier: MIT
#include "root/carried_frame.hpp"

namespace ragdoll {

namespace {

bool is_worlds_own(const Quat &p_orientation, const Vec3 &p_origin) {
	return p_origin.length() == 0.0f && p_orientation.w == 1.0f;
}

} // namespace

void MotionFrame::apply(Pose &r_pose) const {
	if (is_identity) {
		return;
	}
	for (Quat &limb : r_pose.orientations) {
		limb = orientation * limb;
	}
	r_pose.root = orientation.rotate(r_pose.root) + origin;
}

MotionFrame MotionFrame::moved(const Ride &p_ride) const {
	return { (p_ride.turn * orientation).normalized(), p_ride.apply(origin), false };
}

void MotionFrame::save(ArchiveWriter &p_archive) const {
	p_archive.put(orientation);
	p_archive.put(origin);
}

bool MotionFrame::restore(ArchiveReader &p_archive) {
	if (!p_archive.get(orientation) || !p_archive.get(origin) || !orientation.is_finite() || !origin.is_finite()) {
		return false;
	}
	is_identity = is_worlds_own(orientation, origin);
	return true;
}

void CarriedFrame::set(const Quat &p_orientation, const Vec3 &p_origin) {
	_next = { p_orientation, p_origin, is_worlds_own(p_orientation, p_origin) };
	_is_set = true;
}

void CarriedFrame::advance(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts, const RigState &p_state,
		const Ground *p_ground, float p_delta_s) {
	if (_is_set || p_ground == nullptr) {
		// Who is in a seat goes where that goes.
		_carrier.clear();
		_base = _next;
		_is_set = false;
	} else {
		_carrier.advance(p_rig, p_contacts, p_state, *p_ground, p_delta_s);
		_base = _carrier.get_past().moves ? _base.moved(_carrier.get_past()) : _base;
		_now = _base;
		_next = _carrier.get_ahead().moves ? _base.moved(_carrier.get_ahead()) : _base;
	}
	_turn = _next.orientation * _now.orientation.inverse();
	_shift = _next.origin - _turn.rotate(_now.origin);
}

void CarriedFrame::apply(Pose &r_now, Pose &r_next) {
	_now.apply(r_now);
	_next.apply(r_next);
	_now = _next;
}

void CarriedFrame::to_own(std::vector<Quat> &r_orientations, std::vector<Vec3> &r_points) const {
	const Quat back = _next.orientation.inverse();
	for (Quat &orientation : r_orientations) {
		orientation = back * orientation;
	}
	for (Vec3 &point : r_points) {
		point = back.rotate(point - _next.origin);
	}
}

void CarriedFrame::save(ArchiveWriter &p_archive) const {
	_base.save(p_archive);
	_now.save(p_archive);
	_next.save(p_archive);
	p_archive.put(_is_set);
	_carrier.save(p_archive);
}

bool CarriedFrame::restore(ArchiveReader &p_archive) {
	return _base.restore(p_archive) && _now.restore(p_archive) && _next.restore(p_archive) && p_archive.get(_is_set) &&
			_carrier.restore(p_archive);
}

} // namespace ragdoll
