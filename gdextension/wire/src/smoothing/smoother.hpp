// SPDX-License-Identifier: MIT
#pragma once

#include "../dead_reckoning.hpp"
#include "server_clock.hpp"
#include "smoothing_method.hpp"
#include "track.hpp"

#include <skeleton.hpp>

#include <memory>
#include <unordered_map>

namespace wire {

/// Turns updates as they arrive into what a client shows, at its own frame rate.
///
/// Push what arrives, call show() once for each frame of the display, then read persons and bodies.
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

	static constexpr float FARTHEST = 1e5f; ///< Places further from the origin are refused, m.
	static constexpr float FASTEST = 1e4f; ///< Likewise faster bodies, m/s or rad/s.
	static constexpr double LONGEST_DELAY_S = 0.25; ///< Nothing is shown further behind.

	void set_method(SmoothingMethod p_method) { method = p_method; }
	SmoothingMethod get_method() const { return method; }
	/// The server's ticks per second (above 0); forgets all updates if it is another one.
	bool set_tick_rate(double p_rate);
	const ServerClock &get_clock() const { return clock; }

	/// Says how a person's limbs hang together; without it the person's updates are refused. False if
	/// it is no skeleton.
	bool set_skeleton(uint16_t p_id, const kinematics::Skeleton &p_skeleton);
	/// Limbs of the skeleton that was set, or 0.
	int limb_count(uint16_t p_id) const;

	/// Takes an update that arrived at a time of the client's clock, s. False if it is of no use: old,
	/// known, broken, or nobody's.
	bool push(const PersonUpdate &p_update, double p_arrival_s);
	bool push(const BodyUpdate &p_update, double p_arrival_s);

	/// Works out where everything is at a time of the client's clock, s.
	void show(double p_now_s);

	/// The tick that is shown, with its fraction; -1 before the first update.
	double shown_tick() const { return is_playing ? shown_time * clock.tick_rate : -1.0; }
	/// How far what is shown is behind the quickest arrivals, s.
	double delay() const { return behind; }
	/// As shown by show(); null until there is something.
	const Person *person(uint16_t p_id) const;
	const BodyPlace *body(uint16_t p_id) const;
	/// As it was received last, without smoothing; false if there is nothing.
	bool newest(uint16_t p_id, Person &r_person) const;
	bool newest(uint16_t p_id, BodyPlace &r_place) const;

	void forget_person(uint16_t p_id) { persons.erase(p_id); }
	void forget_body(uint16_t p_id) { bodies.erase(p_id); }
	/// Forgets all updates and the clock, but not the skeletons.
	void clear();

private:
	struct PersonEntry {
		explicit PersonEntry(const kinematics::Skeleton &p_skeleton) :
				skeleton(p_skeleton), track(std::size_t(p_skeleton.limb_count), false) {}
		kinematics::Skeleton skeleton;
		PersonTrack track;
		Person shown;
		bool is_shown = false;
	};
	struct BodyEntry {
		BodyTrack track{ 1, true };
		BodyPlace shown;
		bool is_shown = false;
	};

	bool is_timely(uint32_t p_tick, double p_arrival_s);
	double wanted_time(double p_now_s);
	void play(double p_now_s);
	void forget_updates();
	static void place(
			const kinematics::Skeleton &p_skeleton, const Frame<kinematics::MAX_LIMBS> &p_frame, Person &r_person);

	SmoothingMethod method = SmoothingMethod::ADAPTIVE_LOW_DELAY;
	ServerClock clock;
	std::unordered_map<uint16_t, std::unique_ptr<PersonEntry>> persons;
	std::unordered_map<uint16_t, std::unique_ptr<BodyEntry>> bodies;
	bool is_playing = false;
	double shown_time = 0.0; // In the server's clock, s.
	double shown_at = 0.0; // In the client's.
	double behind = 0.0;
};

} // namespace wire
