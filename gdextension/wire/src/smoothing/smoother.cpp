// SPDX-License-Identifier: MIT
#include "smoothing/smoother.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wire {

namespace {

// How many of the arrivals are waited for, and what part of the time between two ADAPTIVE_LOW_DELAY
// stays behind besides: the less there is to guess, the smoother. Frequent updates leave little to
// guess.
constexpr double WAITS_FOR = 0.9;
constexpr double SHARE = 0.2;
constexpr double SHARE_GROWTH = 6.0; // 1/s
// What is shown runs faster or slower by at most this to get to where it should be, per second.
constexpr double CORRECTION = 6.0;
// It is set anew if it is further off, s.
constexpr double JUMP_S = 0.25;

bool is_position(const Vec3 &p_position) {
	return p_position.is_finite() && std::fabs(p_position.x) <= Smoother::FARTHEST &&
			std::fabs(p_position.y) <= Smoother::FARTHEST && std::fabs(p_position.z) <= Smoother::FARTHEST;
}

// NaN fails too.
bool is_turn(const Quat &p_turn) {
	const float square = p_turn.dot(p_turn);
	return square > 0.25f && square < 4.0f;
}

bool is_same(const BodyTransform &p_one, const BodyTransform &p_other) {
	const Vec3 &a = p_one.position;
	const Vec3 &b = p_other.position;
	const Quat &s = p_one.orientation;
	const Quat &t = p_other.orientation;
	return a.x == b.x && a.y == b.y && a.z == b.z && s.x == t.x && s.y == t.y && s.z == t.z && s.w == t.w;
}

bool is_speed(const Vec3 &p_speed) {
	return p_speed.length() <= Smoother::FASTEST;
}

} // namespace

bool Smoother::set_tick_rate(double p_rate) {
	if (!(p_rate > 0.0 && p_rate <= 1000.0)) {
		return false;
	}
	if (p_rate != _clock.tick_rate) {
		clear();
		_clock.tick_rate = p_rate;
	}
	return true;
}

bool Smoother::set_skeleton(uint16_t p_id, const kinematics::Skeleton &p_skeleton) {
	if (!p_skeleton.is_sound()) {
		return false;
	}
	for (std::size_t i = 0; i < std::size_t(p_skeleton.limb_count); i++) {
		if (!is_position(p_skeleton.joints_in_parent[i]) || !is_position(p_skeleton.joints_in_limb[i])) {
			return false;
		}
	}
	const auto known = _persons.find(p_id);
	if (known != _persons.end() && known->second->skeleton.limb_count == p_skeleton.limb_count) {
		known->second->skeleton = p_skeleton;
	} else {
		_persons[p_id] = std::make_unique<PersonEntry>(p_skeleton);
	}
	return true;
}

int Smoother::limb_count(uint16_t p_id) const {
	const auto found = _persons.find(p_id);
	return found != _persons.end() ? found->second->skeleton.limb_count : 0;
}

bool Smoother::_is_timely(uint32_t p_tick, double p_arrival_s) {
	if (!std::isfinite(p_arrival_s)) {
		return false;
	}
	const ServerClock::Verdict verdict = _clock.arrived(p_tick, p_arrival_s);
	if (verdict == ServerClock::Verdict::NEW_SERVER) {
		_forget_updates();
	}
	return verdict != ServerClock::Verdict::OUTLANDISH;
}

bool Smoother::push(const PersonUpdate &p_update, double p_arrival_s) {
	const auto found = _persons.find(p_update.id);
	if (found == _persons.end() || !is_position(p_update.pose.root)) {
		return false;
	}
	PersonTrack::Key key;
	key.frame.position = p_update.pose.root;
	for (std::size_t i = 0; i < std::size_t(found->second->skeleton.limb_count); i++) {
		if (!is_turn(p_update.pose.orientations[i])) {
			return false;
		}
		key.frame.turns[i] = p_update.pose.orientations[i].normalized();
	}
	if (!_is_timely(p_update.tick, p_arrival_s)) {
		return false;
	}
	key.time = _clock.time_of(p_update.tick);
	key.arrival = p_arrival_s;
	return _fit_frames(*found->second, p_update.frame, key) && found->second->track.push(key);
}

bool Smoother::push(const BodyUpdate &p_update, double p_arrival_s) {
	const bool is_sound = is_position(p_update.position) && is_turn(p_update.orientation) &&
			is_speed(p_update.velocity) && is_speed(p_update.spin);
	if (!is_sound || !_is_timely(p_update.tick, p_arrival_s)) {
		return false;
	}
	BodyTrack::Key key;
	key.time = _clock.time_of(p_update.tick);
	key.arrival = p_arrival_s;
	key.frame.position = p_update.position;
	key.frame.turns[0] = p_update.orientation.normalized();
	key.at_rest = p_update.at_rest;
	if (!p_update.at_rest) {
		key.motion.displacement = p_update.velocity;
		key.motion.turns[0] = p_update.spin;
	}
	std::unique_ptr<BodyEntry> &entry = _bodies[p_update.id];
	if (!entry) {
		entry = std::make_unique<BodyEntry>();
		_moved_bodies.reserve(_bodies.size());
	}
	return entry->track.push(key);
}

/// The server's time that the method would like to show.
double Smoother::_wanted_time(double p_now_s) {
	const double share = std::min(SHARE, SHARE_GROWTH * _clock.interval());
	switch (_method) {
		case SmoothingMethod::LINEAR:
		case SmoothingMethod::HERMITE:
			_behind = std::min(std::max(BUFFER_S, _clock.interval() + _clock.lateness(WAITS_FOR)), MAX_DELAY_S);
			break;
		case SmoothingMethod::ADAPTIVE_LOW_DELAY:
			_behind = std::min(_clock.lateness(WAITS_FOR) + share * _clock.interval(), MAX_DELAY_S);
			break;
		default:
			_behind = 0.0;
	}
	return _clock.server_now(p_now_s) - _behind;
}

/// Lets what is shown run on, a little faster or slower than time, to where it should be.
void Smoother::_play(double p_now_s) {
	const double wanted = _wanted_time(p_now_s);
	const double step = p_now_s - _shown_at;
	const double error = wanted - (_played_time + step);
	if (!_is_playing || step < 0.0 || std::fabs(error) > JUMP_S) {
		_played_time = wanted;
	} else {
		// Never back, however much too far ahead it is.
		_played_time += std::max(step + error * (1.0 - std::exp(-CORRECTION * step)), 0.0);
	}
	_shown_time = _played_time;
	_shown_behind = std::max(_clock.lately_now(p_now_s) - _shown_time, 0.0);
	_shown_at = p_now_s;
	_is_playing = true;
}

double Smoother::_motion_time() const {
	const double ahead = std::max(_shown_time - _clock.newest(), 0.0);
	switch (_method) {
		case SmoothingMethod::NONE:
			return _clock.newest();
		case SmoothingMethod::LINEAR:
		case SmoothingMethod::HERMITE:
			return std::min(_shown_time, _clock.newest());
		case SmoothingMethod::EXTRAPOLATE_LERP:
			return std::min(_shown_time, _clock.newest() + _clock.interval());
		case SmoothingMethod::ERROR_OFFSET:
			return _shown_time - ahead + carried_on(ahead, FAR_REACH_S);
		default:
			return _shown_time - ahead + carried_on(ahead, REACH_S);
	}
}

void Smoother::evaluate(double p_now_s) {
	_moved_bodies.clear();
	if (_clock.is_known() && std::isfinite(p_now_s)) {
		_play(p_now_s);
		_show(p_now_s);
	}
}

bool Smoother::show_tick(double p_tick, double p_now_s) {
	_moved_bodies.clear();
	if (!_is_playing || !std::isfinite(p_now_s) || !(p_tick >= 0.0 && p_tick <= double(UINT32_MAX))) {
		return false;
	}
	_shown_time = p_tick / _clock.tick_rate;
	_shown_behind = std::max(_clock.lately_now(p_now_s) - _shown_time, 0.0);
	_show(p_now_s);
	return true;
}

void Smoother::_show(double p_now_s) {
	for (auto &[id, entry] : _bodies) {
		if (!entry->track.is_empty()) {
			entry->track.evaluate({ _shown_time, p_now_s, _method });
			BodyTransform shown{ entry->track.get_shown().position, entry->track.get_shown().turns[0] };
			if (entry->is_predicted) {
				shown = entry->predicted;
			}
			if (!entry->is_shown || !is_same(shown, entry->shown)) {
				_moved_bodies.push_back(id);
			}
			entry->shown = shown;
			entry->is_shown = true;
		}
	}
	// After the bodies that carry them.
	for (auto &[id, entry] : _persons) {
		if (!entry->track.is_empty()) {
			_evaluate_person(*entry, p_now_s);
		}
	}
}

void Smoother::_evaluate_person(PersonEntry &r_entry, double p_now_s) {
	r_entry.track.evaluate({ _shown_time, p_now_s, _method });
	Frame<1> carrier;
	// Somebody whose carrier has not come yet waits for it.
	if (_carrier_shown(r_entry.frame, carrier)) {
		const std::size_t count = std::size_t(r_entry.skeleton.limb_count);
		const Frame<kinematics::MAX_LIMBS> &frame = r_entry.track.get_shown();
		_pose_person(r_entry.skeleton, r_entry.frame == 0 ? frame : carried(carrier, frame, count), r_entry.shown);
		r_entry.is_shown = true;
	}
}

bool Smoother::predict_body(uint16_t p_id, const BodyTransform &p_transform) {
	const auto found = _bodies.find(p_id);
	if (found == _bodies.end() || !is_position(p_transform.position) || !is_turn(p_transform.orientation)) {
		return false;
	}
	found->second->predicted = { p_transform.position, p_transform.orientation.normalized() };
	found->second->is_predicted = true;
	return true;
}

void Smoother::forget_prediction(uint16_t p_id) {
	const auto found = _bodies.find(p_id);
	if (found != _bodies.end()) {
		found->second->is_predicted = false;
	}
}

// Where a carrier is at a time, without what smooths its display; false if nobody knows.
bool Smoother::_carrier_at(uint16_t p_frame, double p_time, Frame<1> &r_carrier) const {
	r_carrier = Frame<1>();
	if (p_frame == 0) {
		return true;
	}
	const auto found = _bodies.find(p_frame);
	if (found == _bodies.end() || found->second->track.is_empty()) {
		return false;
	}
	r_carrier = found->second->track.at(p_time);
	return true;
}

bool Smoother::_carrier_shown(uint16_t p_frame, Frame<1> &r_carrier) const {
	r_carrier = Frame<1>();
	if (p_frame == 0) {
		return true;
	}
	const auto found = _bodies.find(p_frame);
	if (found == _bodies.end() || !found->second->is_shown) {
		return false;
	}
	r_carrier.position = found->second->shown.position;
	r_carrier.turns[0] = found->second->shown.orientation;
	return true;
}

// Brings a person's track and a new update into one frame: that of the newest. False if the update is of no use.
bool Smoother::_fit_frames(PersonEntry &r_entry, uint16_t p_frame, PersonTrack::Key &r_key) const {
	if (p_frame == r_entry.frame) {
		return true;
	}
	const std::size_t count = std::size_t(r_entry.skeleton.limb_count);
	const auto convert = [&](uint16_t p_from, uint16_t p_to, const Frame<kinematics::MAX_LIMBS> &p_what,
								 double p_time) {
		Frame<1> from;
		Frame<1> to;
		_carrier_at(p_from, p_time, from);
		_carrier_at(p_to, p_time, to);
		return seen_from(to, carried(from, p_what, count), count);
	};
	Frame<1> before;
	Frame<1> after;
	const bool is_known = _carrier_at(r_entry.frame, r_key.time, before) && _carrier_at(p_frame, r_key.time, after);
	const bool is_newest = r_entry.track.is_empty() || r_entry.track.get_newest().time < r_key.time;
	if (!is_newest) {
		r_key.frame = is_known ? convert(p_frame, r_entry.frame, r_key.frame, r_key.time) : r_key.frame;
		return is_known;
	}
	if (is_known && _carrier_shown(r_entry.frame, before) && _carrier_shown(p_frame, after)) {
		const uint16_t left = r_entry.frame;
		r_entry.track.reframe([&](const auto &p_what, double p_time) { return convert(left, p_frame, p_what, p_time); },
				[&](const auto &p_what) { return seen_from(after, carried(before, p_what, count), count); });
	} else {
		r_entry.track = PersonTrack(count, false);
	}
	r_entry.frame = p_frame;
	return true;
}

bool Smoother::push(uint32_t p_tick, uint16_t p_id, const EntityType &p_type, uint32_t p_generation,
		const uint32_t *p_spawn, const uint32_t *p_values, double p_arrival_s) {
	if (!_is_timely(p_tick, p_arrival_s)) {
		return false;
	}
	std::unique_ptr<FieldEntry> &entry = _fields[p_id];
	if (!entry || entry->generation != p_generation) {
		entry = std::make_unique<FieldEntry>(FieldEntry{ p_generation, FieldTrack(p_type, p_spawn) });
	}
	return entry->track.push(_clock.time_of(p_tick), p_values, _clock.interval());
}

const FieldTrack *Smoother::fields(uint16_t p_id, uint32_t p_generation) const {
	const auto found = _fields.find(p_id);
	return found != _fields.end() && found->second->generation == p_generation ? &found->second->track : nullptr;
}

void Smoother::_pose_person(
		const kinematics::Skeleton &p_skeleton, const Frame<kinematics::MAX_LIMBS> &p_frame, Person &r_person) {
	r_person.limb_count = p_skeleton.limb_count;
	r_person.pose.root = p_frame.position;
	r_person.pose.orientations = p_frame.turns;
	kinematics::position_limbs(p_skeleton, r_person.pose, r_person.positions);
}

const Smoother::Person *Smoother::person(uint16_t p_id) const {
	const auto found = _persons.find(p_id);
	return found != _persons.end() && found->second->is_shown ? &found->second->shown : nullptr;
}

const BodyTransform *Smoother::body(uint16_t p_id) const {
	const auto found = _bodies.find(p_id);
	return found != _bodies.end() && found->second->is_shown ? &found->second->shown : nullptr;
}

bool Smoother::newest(uint16_t p_id, Person &r_person) const {
	const auto found = _persons.find(p_id);
	if (found == _persons.end() || found->second->track.is_empty()) {
		return false;
	}
	const PersonEntry &entry = *found->second;
	const PersonTrack::Key &key = entry.track.get_newest();
	Frame<1> carrier;
	if (!_carrier_at(entry.frame, key.time, carrier)) {
		return false;
	}
	const std::size_t count = std::size_t(entry.skeleton.limb_count);
	_pose_person(entry.skeleton, entry.frame == 0 ? key.frame : carried(carrier, key.frame, count), r_person);
	return true;
}

bool Smoother::newest(uint16_t p_id, BodyTransform &r_transform) const {
	const auto found = _bodies.find(p_id);
	if (found == _bodies.end() || found->second->track.is_empty()) {
		return false;
	}
	const Frame<1> &frame = found->second->track.get_newest().frame;
	r_transform = { frame.position, frame.turns[0] };
	return true;
}

void Smoother::_forget_updates() {
	for (auto &[id, entry] : _persons) {
		entry->track.clear();
	}
	// What the new server does not speak of is not there.
	_bodies.clear();
	_fields.clear();
	_is_playing = false;
}

void Smoother::clear() {
	_forget_updates();
	for (auto &[id, entry] : _persons) {
		entry->is_shown = false;
	}
	_clock.clear();
}

} // namespace wire
