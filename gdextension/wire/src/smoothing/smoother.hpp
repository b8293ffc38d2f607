// SPDX-License-Identifier: MIT
#pragma once

#include "dead_reckoning.hpp"
#include "smoothing/field_track.hpp"
#include "smoothing/server_clock.hpp"
#include "smoothing/smoothing_method.hpp"
#include "smoothing/track.hpp"

#include <skeleton.hpp>

#include <memory>
#include <unordered_map>
#include <vector>

namespace wire {

/// Turns updates as they arrive into what a client shows, at its own frame rate.
///
/// Push what arrives, call evaluate() once for each frame of the display, then read persons and bodies.
/// Memory is only allocated when somebody or something is seen for the first time. Any update may be
/// late, twice, out of order, missing or broken: what makes no sense is refused.
class Smoother {
public:
	using PersonTrack = Track<kinematics::MAX_LIMBS>;
	using BodyTrack = Track<1>;

	/// A person as shown.
	struct Person {
		PersonPose pose;
		std::array<Vec3, kinematics::MAX_LIMBS> positions{}; ///< Of the limbs' frames, m.
		int limb_count = 0;
	};

	static constexpr float FARTHEST = 1e5f; ///< Positions further from the origin are refused, m.
	static constexpr float FASTEST = 1e4f; ///< Likewise faster bodies, m/s or rad/s.
	static constexpr double MAX_DELAY_S = 0.25; ///< Nothing is shown further behind.

	void set_method(SmoothingMethod p_method) { _method = p_method; }
	SmoothingMethod get_method() const { return _method; }
	/// The server's ticks per second (above 0); forgets all updates if it is another one.
	bool set_tick_rate(double p_rate);
	const ServerClock &get_clock() const { return _clock; }

	/// Says how a person's limbs hang together; without it the person's updates are refused. False if
	/// it is no skeleton.
	bool set_skeleton(uint16_t p_id, const kinematics::Skeleton &p_skeleton);
	/// Limbs of the skeleton that was set, or 0.
	int limb_count(uint16_t p_id) const;

	/// Takes an update that arrived at a time of the client's clock, s. False if it is of no use: old,
	/// known, broken, or nobody's.
	bool push(const PersonUpdate &p_update, double p_arrival_s);
	bool push(const BodyUpdate &p_update, double p_arrival_s);

	/// Takes an entity's fields. A generation other than before is another entity of that id.
	bool push(uint32_t p_tick, uint16_t p_id, const EntityType &p_type, uint32_t p_generation, const uint32_t *p_spawn,
			const uint32_t *p_values, double p_arrival_s);

	/// Works out where everything is at a time of the client's clock, s.
	void evaluate(double p_now_s);

	/// Works out where everything is at a tick of the server (with its fraction) that somebody else has chosen, such as
	/// the first display of a station, after evaluate() at the same time of the client's clock, s. False, and nothing,
	/// for a tick that is none.
	bool show_tick(double p_tick, double p_now_s);

	/// Shows a body somewhere else than its updates say, until forget_prediction(): where this client has worked out
	/// that it will be. Who is carried by it is shown there too. False, and nothing, for a body without updates or a
	/// place that is none.
	bool predict_body(uint16_t p_id, const BodyTransform &p_transform);
	/// Shows a body as its updates say again.
	void forget_prediction(uint16_t p_id);

	/// The tick that is shown, with its fraction; -1 before the first update.
	double shown_tick() const { return _is_playing ? _shown_time * _clock.tick_rate : -1.0; }
	/// The tick of the motion of people that is shown, with its fraction: shown_tick(), but beyond the newest update
	/// only as far as motion is carried on. -1 before the first update.
	double motion_tick() const { return _is_playing ? _motion_time() * _clock.tick_rate : -1.0; }
	/// How far what is shown is behind the quickest arrivals, s.
	double delay() const { return _shown_behind; }
	/// As shown by evaluate(); null until there is something.
	const Person *person(uint16_t p_id) const;
	const BodyTransform *body(uint16_t p_id) const;
	/// Bodies that the last evaluate() put elsewhere than the one before, or showed for the first time.
	const std::vector<uint16_t> &moved_bodies() const { return _moved_bodies; }
	/// As it was received last, without smoothing; false if there is nothing.
	bool newest(uint16_t p_id, Person &r_person) const;
	bool newest(uint16_t p_id, BodyTransform &r_transform) const;

	/// An entity's fields, if something has come of them since it was added.
	const FieldTrack *fields(uint16_t p_id, uint32_t p_generation) const;
	/// A field as it is shown.
	float shown_field(const FieldTrack &p_track, std::size_t p_field) const {
		return _is_playing ? p_track.at(p_field, _shown_time) : p_track.newest(p_field);
	}
	void forget_fields(uint16_t p_id) { _fields.erase(p_id); }
	void forget_person(uint16_t p_id) { _persons.erase(p_id); }
	void forget_body(uint16_t p_id) { _bodies.erase(p_id); }
	/// Forgets all updates and the clock, but not the skeletons.
	void clear();

private:
	struct PersonEntry {
		explicit PersonEntry(const kinematics::Skeleton &p_skeleton) :
				skeleton(p_skeleton), track(std::size_t(p_skeleton.limb_count), false) {}
		kinematics::Skeleton skeleton;
		PersonTrack track;
		uint16_t frame = 0; // Id of the body in whose frame the track is; 0: in the world's.
		Person shown;
		bool is_shown = false;
	};
	struct FieldEntry {
		uint32_t generation;
		FieldTrack track;
	};
	struct BodyEntry {
		BodyTrack track{ 1, true };
		BodyTransform shown;
		BodyTransform predicted;
		bool is_shown = false;
		bool is_predicted = false;
	};

	bool _carrier_at(uint16_t p_frame, double p_time, Frame<1> &r_carrier) const;
	bool _carrier_shown(uint16_t p_frame, Frame<1> &r_carrier) const;
	bool _fit_frames(PersonEntry &r_entry, uint16_t p_frame, PersonTrack::Key &r_key) const;
	void _evaluate_person(PersonEntry &r_entry, double p_now_s);
	bool _is_timely(uint32_t p_tick, double p_arrival_s);
	double _wanted_time(double p_now_s);
	double _motion_time() const;
	void _play(double p_now_s);
	void _show(double p_now_s);
	void _forget_updates();
	static void _pose_person(
			const kinematics::Skeleton &p_skeleton, const Frame<kinematics::MAX_LIMBS> &p_frame, Person &r_person);

	SmoothingMethod _method = SmoothingMethod::ADAPTIVE_LOW_DELAY;
	ServerClock _clock;
	std::unordered_map<uint16_t, std::unique_ptr<PersonEntry>> _persons;
	std::unordered_map<uint16_t, std::unique_ptr<BodyEntry>> _bodies;
	std::unordered_map<uint16_t, std::unique_ptr<FieldEntry>> _fields;
	std::vector<uint16_t> _moved_bodies;
	bool _is_playing = false;
	double _played_time = 0.0; // What this client by itself would show, in the server's clock, s.
	double _shown_time = 0.0; // What it shows.
	double _shown_at = 0.0; // In the client's.
	double _shown_behind = 0.0;
	double _behind = 0.0;
};

} // namespace wire
