// SPDX-License-Identifier: MIT
#include "driver.hpp"

#include "gait/inertial_gait.hpp"
#include "gait/lowest_contact.hpp"
#include "gait/lowest_foot.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

Driver::Driver(Rig p_rig, const std::vector<int> &p_groups, std::size_t p_group_count,
		const std::vector<ContactPoint> &p_contacts) :
		rig(std::move(p_rig)),
		stream(rig.size()),
		table(p_groups, p_group_count),
		controller(rig),
		torques(rig.size()),
		errors(rig.size(), 0.0f),
		saturations(rig.size(), 0.0f),
		contacts(p_contacts),
		points_now(p_contacts.size()),
		points_next(p_contacts.size()),
		points_shown(p_contacts.size()) {
	foot_lock = FootLock(rig, p_contacts);
	travels[0] = std::make_unique<LowestFoot>(p_contacts);
	travels[1] = std::make_unique<LowestContact>(p_contacts);
	travels[2] = std::make_unique<InertialGait>(p_contacts);
	commands.orientations.resize(rig.size());
	commands.joints.resize(rig.size());
}

bool Driver::push(double p_time_s, const float *p_orientations, const Vec3 &p_root, const float *p_rates) {
	stream.set_calms(finds_travel(root_mode)); // Noise in the pose makes feet skate that have to stand.
	const double before = stream.is_empty() ? p_time_s : stream.newest();
	if (!stream.push(p_time_s, p_orientations, p_root, p_rates)) {
		return false;
	}
	if (p_time_s < before) {
		meter.forget_waiting(); // The clock has been set back.
	}
	meter.settle(stream, rig);
	return true;
}

void Driver::clear_motion() {
	stream.clear();
	meter.forget_waiting();
	alive = NEVER;
}

const StepCommands &Driver::step(RigState &r_state, double p_time_s, float p_delta_s) {
	stream.predict(p_time_s, now);
	stream.predict(p_time_s + double(p_delta_s), next);
	commands.guarded = guard.check(rig, r_state);
	commands.must_put = commands.guarded != GUARD_NOTHING;
	const bool teleported = stream.take_teleport() && !finds_travel(root_mode) && !is_free(root_mode);
	if (has_come_back(p_time_s) || teleported || (commands.guarded & GUARD_LOST) != 0) {
		put_into_pose(r_state);
		commands.must_put = true;
	}
	travel(r_state, p_delta_s);
	let_go_when_stalled(p_time_s);
	table.advance(p_delta_s);
	compute_limbs(r_state, p_delta_s);
	note_torques(r_state, p_delta_s);
	command_root(r_state, p_delta_s);
	if (table.has_mode(Actuation::DIRECT_SET)) {
		place_limbs(rig, r_state, next, p_delta_s, table, commands.orientations, commands.joints);
	}
	if (commands.is_root_held && table.get_mode(0) != Actuation::DIRECT_SET) {
		hold_root(r_state, p_delta_s);
	}
	was_held = commands.is_root_held;
	return commands;
}

void Driver::hold_root(const RigState &p_state, float p_delta_s) {
	commands.orientations[0] = next.orientations[0];
	commands.joints[0] = next.root + lift;
	const Vec3 way = commands.joints[0] - p_state.root;
	const Vec3 turn = log(p_state.orientations[0].inverse() * next.orientations[0]);
	const float distance = way.length() - (next.root - now.root).length();
	const float angle = turn.length() - angle_between(now.orientations[0], next.orientations[0]);
	is_fetched = (is_fetched || !was_held) && (distance > FETCHED || angle > FETCHED);
	if (is_fetched) {
		const float part =
				std::min(1.0f, p_delta_s / std::max(std::max(distance / FETCH_SPEED, angle / FETCH_TURN), p_delta_s));
		commands.orientations[0] = p_state.orientations[0] * exp(turn * part);
		commands.joints[0] = p_state.root + way * part;
	}
}

void Driver::compute_limbs(const RigState &p_state, float p_delta_s) {
	// A body that stands on shaking feet skates: noise is followed less eagerly.
	const float calmed = get_travel() ? CALMED * stream.get_filter().get_unrest() : 0.0f;
	controller.settings.eagerness = 1.0f - calmed;
	controller.compute(p_state, now, next, p_delta_s, table, commands.limbs);
}

bool Driver::has_come_back(double p_time_s) {
	if (stream.is_stalled(p_time_s)) {
		return false;
	}
	const bool paused = p_time_s - alive > PUT_AFTER;
	alive = p_time_s;
	return paused;
}

Travel *Driver::find_travel(RootMode p_mode) const {
	switch (p_mode) {
		case RootMode::LOWEST_FOOT:
			return travels[0].get();
		case RootMode::CONTACTS:
			return travels[1].get();
		case RootMode::INERTIAL:
			return travels[2].get();
		default:
			return nullptr;
	}
}

void Driver::find_points(const Pose &p_pose, std::vector<Vec3> &r_points) {
	rig.joint_positions(p_pose, joints);
	for (std::size_t i = 0; i < contacts.size(); i++) {
		const std::size_t limb = std::size_t(contacts[i].limb);
		r_points[i] = joints[limb] + p_pose.orientations[limb].rotate(contacts[i].local);
	}
}

void Driver::find_shown(const RigState &p_state) {
	for (std::size_t i = 0; i < contacts.size(); i++) {
		const std::size_t limb = std::size_t(contacts[i].limb);
		points_shown[i] = rig.joint_of(p_state, limb) + p_state.orientations[limb].rotate(contacts[i].local);
	}
}

void Driver::travel(const RigState &p_state, float p_delta_s) {
	Travel *estimator = find_travel(root_mode);
	const bool goes_on = travelled == root_mode;
	const Vec3 expected = next_root; // Where the last step should have brought the root.
	travelled = root_mode;
	if (!estimator) {
		next_root = next.root;
		return;
	}
	if (!goes_on) {
		estimator->reset(p_state.root);
		foot_lock.clear();
		path.clear();
	} else {
		const Vec3 off = p_state.root - expected;
		const bool limp = table.get_mode(0) == Actuation::LIMP;
		const Vec3 across{ off.x, limp ? off.y : 0.0f, off.z };
		const float distance = across.length();
		const float slack = limp ? 0.0f : SLACK;
		if (distance > slack) {
			const Vec3 given = across * (1.0f - slack / distance);
			estimator->shift(given);
			foot_lock.shift(given);
			path.shift(given);
		}
	}
	now.root = {};
	next.root = {};
	find_points(next, points_next);
	find_points(now, points_now);
	const Vec3 centre = rig.centre_of_mass(now, joints);
	estimator->step({ p_delta_s, &points_now, centre, ground ? ground : &level_ground });
	now.root = estimator->get_root();
	next.root = estimator->ahead(points_next, p_delta_s);
	const PoseFilter &filter = stream.get_filter();
	path.advance(now.root, filter.get_noise(), p_delta_s);
	if (filter.get_noise() > 0.0f) {
		now.root = path.get_place();
		next.root = path.ahead(p_delta_s);
	}
	next_root = next.root;
	find_shown(p_state);
	foot_lock.advance(*estimator, now.root, points_now, points_shown, filter.get_unrest(), p_delta_s);
	rig.joint_positions(now, joints);
	foot_lock.apply(rig, filter.get_unrest(), now, joints);
	rig.joint_positions(next, joints);
	foot_lock.apply(rig, filter.get_unrest(), next, joints);
}

void Driver::let_go_when_stalled(double p_time_s) {
	const bool stalled = p_time_s - stream.newest() > LET_GO_AFTER;
	table.set_overall(stalled ? STALLED_STRENGTH : 1.0f, LET_GO_S);
}

void Driver::command_root(const RigState &p_state, float p_delta_s) {
	const Actuation mode = table.get_mode(0);
	commands.is_root_held = mode == Actuation::DIRECT_SET || (root_mode == RootMode::HELD && mode != Actuation::LIMP);
	root_settings.gain = controller.settings.gain * controller.settings.eagerness;
	lift = { 0.0f, lift_while_getting_up(p_state), 0.0f };
	const float strength = mode == Actuation::LIMP ? 0.0f : table.get_standing_strength(0);
	commands.root = drive_root(
			root_mode, root_settings, rig, p_state.root, now.root + lift, next.root + lift, p_delta_s, strength);
	commands.root_turn = commands.limbs[0].velocity;
	if (root_mode == RootMode::SELF_RIGHTING && righted_limb > 0) {
		const std::size_t limb = std::size_t(righted_limb);
		commands.trunk_turn = righting_velocity(p_state.orientations[limb], now.orientations[limb],
				next.orientations[limb], p_delta_s, controller.settings.gain);
	}
}

float Driver::lift_while_getting_up(const RigState &p_state) {
	const bool limp = table.get_mode(0) == Actuation::LIMP;
	is_getting_up = (is_getting_up || was_limp) && !limp;
	was_limp = limp;
	if (!is_getting_up) {
		return 0.0f;
	}
	float error = 0.0f;
	for (const float off : find_errors(p_state)) {
		error += off / float(rig.size());
	}
	is_getting_up = error > UPRIGHT;
	return std::min(error, 0.5f) * GETTING_UP_LIFT;
}

const std::vector<float> &Driver::find_errors(const RigState &p_state) {
	for (std::size_t i = 0; i < now.orientations.size(); i++) {
		errors[i] = angle_between(p_state.orientations[i], now.orientations[i]);
	}
	return errors;
}

void Driver::note_torques(const RigState &p_state, float p_delta_s) {
	if (!measures_torque) {
		return;
	}
	torques.note(rig, p_state, p_delta_s, 9.81f);
	for (std::size_t i = 0; i < rig.size(); i++) {
		const float most = i == 0 ? root_settings.torque : rig[i].max_torque * table.get_strength(i);
		saturations[i] = most > 0.0f ? torques.get_torques()[i] / most : 0.0f;
	}
}

void Driver::put_into_pose(RigState &r_state) {
	if (find_travel(root_mode) && travelled == root_mode) {
		now.root = next_root;
	}
	rig.joint_positions(now, joints);
	for (std::size_t i = 0; i < rig.size(); i++) {
		r_state.orientations[i] = now.orientations[i];
		r_state.centres[i] = joints[i] + now.orientations[i].rotate(rig[i].centre);
		r_state.linear[i] = {};
		r_state.angular[i] = {};
	}
	r_state.root = now.root;
	controller.reset();
	torques.clear();
}

void Driver::pose_state(double p_time_s, RigState &r_state) {
	stream.predict(p_time_s, now);
	next = now;
	put_into_pose(r_state);
}

void Driver::measure(double p_time_s, const RigState &p_state) {
	if (stream.is_empty() || stream.is_stalled(p_time_s)) {
		return;
	}
	joints.resize(rig.size());
	for (std::size_t i = 0; i < rig.size(); i++) {
		joints[i] = rig.joint_of(p_state, i);
	}
	meter.note(p_time_s, p_state.orientations, joints);
}

std::uint64_t Driver::fingerprint() const {
	StateHash hash;
	for (std::size_t i = 0; i < rig.size(); i++) {
		hash.add(rig[i].parent);
		hash.add(rig[i].group);
		hash.add(rig[i].anchor);
		hash.add(rig[i].centre);
		hash.add(rig[i].rest);
		hash.add(rig[i].mass);
	}
	for (const ContactPoint &contact : contacts) {
		hash.add(contact.limb);
		hash.add(contact.local);
		hash.add(contact.radius);
		hash.add(contact.sole);
	}
	return hash.get();
}

void Driver::save(ArchiveWriter &p_archive) const {
	p_archive.put(fingerprint());
	p_archive.put(root_mode);
	p_archive.put(alive);
	p_archive.put(was_limp);
	p_archive.put(is_getting_up);
	p_archive.put(was_held);
	p_archive.put(is_fetched);
	p_archive.put(travelled);
	p_archive.put(next_root);
	for (const std::unique_ptr<Travel> &estimator : travels) {
		estimator->save(p_archive);
	}
	foot_lock.save(p_archive);
	path.save(p_archive);
	stream.save(p_archive);
	table.save(p_archive);
	controller.save(p_archive);
}

bool Driver::restore(ArchiveReader &p_archive) {
	ArchiveWriter before;
	save(before);
	if (read(p_archive)) {
		return true;
	}
	ArchiveReader back(before.get_bytes().data(), before.get_bytes().size());
	read(back);
	return false;
}

bool Driver::read(ArchiveReader &p_archive) {
	std::uint64_t whose = 0;
	RootMode mode = RootMode::SOFT;
	// Archives hold places in tables: those of another body must not come any further.
	if (!p_archive.get(whose) || whose != fingerprint() || !p_archive.get(mode) || int(mode) < 0 ||
			int(mode) >= ROOT_MODE_COUNT || !p_archive.get(alive) || !p_archive.get(was_limp) ||
			!p_archive.get(is_getting_up) || !p_archive.get(was_held) || !p_archive.get(is_fetched)) {
		return false;
	}
	root_mode = mode;
	torques.clear();
	p_archive.get(travelled);
	p_archive.get(next_root);
	for (const std::unique_ptr<Travel> &estimator : travels) {
		if (!estimator->restore(p_archive)) {
			return false;
		}
	}
	return foot_lock.restore(p_archive) && path.restore(p_archive) && stream.restore(p_archive) &&
			table.restore(p_archive) && controller.restore(p_archive);
}

} // namespace ragdoll
