// SPDX-License-Identifier: MIT
#include "joint/actuation.hpp"

#include <algorithm>

namespace ragdoll {

float Ramp::get() const {
	if (!is_moving()) {
		return _to;
	}
	const float part = _elapsed / _duration;
	return _from + (_to - _from) * part * part * (3.0f - 2.0f * part);
}

void Ramp::go(float p_to, float p_duration_s) {
	_from = get();
	_to = p_to;
	_elapsed = 0.0f;
	_duration = std::max(p_duration_s, 0.0f);
}

void Ramp::advance(float p_delta_s) {
	_elapsed = std::min(_elapsed + p_delta_s, _duration);
}

ActuationTable::ActuationTable(const std::vector<int> &p_groups, std::size_t p_group_count) :
		_limbs(p_groups.size()), _groups(p_group_count), _scales(p_groups.size(), 1.0f) {
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		_limbs[i].group = p_groups[i];
	}
}

void ActuationTable::change(LimbState &r_limb, Actuation p_mode, float p_blend_s) {
	if (p_mode == r_limb.wanted) {
		return;
	}
	r_limb.wanted = p_mode;
	if (p_mode == Actuation::LIMP && r_limb.mode != Actuation::DIRECT_SET && p_blend_s > 0.0f) {
		r_limb.authority.go(LIMP_FRICTION, p_blend_s); // Falls limp when the ramp has ended.
		return;
	}
	if (r_limb.mode == Actuation::LIMP) {
		r_limb.authority = Ramp(LIMP_FRICTION);
	}
	r_limb.arrival = Ramp(p_mode == Actuation::DIRECT_SET ? 0.0f : 1.0f);
	r_limb.arrival.go(1.0f, p_blend_s);
	r_limb.authority.go(p_mode == Actuation::LIMP ? LIMP_FRICTION : 1.0f, p_blend_s);
	r_limb.mode = p_mode;
}

void ActuationTable::set_mode(Actuation p_mode, int p_group, float p_blend_s) {
	for (LimbState &limb : _limbs) {
		if (p_group < 0 || limb.group == p_group) {
			change(limb, p_mode, p_blend_s);
		}
	}
}

void ActuationTable::set_strength(float p_strength, int p_group, float p_blend_s) {
	for (std::size_t i = 0; i < _groups.size(); i++) {
		if (p_group < 0 || int(i) == p_group) {
			_groups[i].strength.go(std::max(p_strength, 0.0f), p_blend_s);
		}
	}
}

void ActuationTable::set_spring(float p_frequency, float p_damping_ratio, int p_group) {
	for (std::size_t i = 0; i < _groups.size(); i++) {
		if (p_group < 0 || int(i) == p_group) {
			_groups[i].frequency = std::max(p_frequency, 0.0f);
			_groups[i].damping_ratio = std::max(p_damping_ratio, 0.0f);
		}
	}
}

void ActuationTable::set_overall(float p_strength, float p_blend_s) {
	if (_overall.get_target() != p_strength) {
		_overall.go(p_strength, p_blend_s);
	}
}

void ActuationTable::advance(float p_delta_s) {
	_overall.advance(p_delta_s);
	for (GroupSettings &group : _groups) {
		group.strength.advance(p_delta_s);
	}
	for (LimbState &limb : _limbs) {
		limb.authority.advance(p_delta_s);
		limb.arrival.advance(p_delta_s);
		for (Ramp *ramp : { &limb.share, &limb.flinch, &limb.blend, &limb.frequency, &limb.damping_ratio }) {
			ramp->advance(p_delta_s);
		}
		if (limb.wanted == Actuation::LIMP && !limb.authority.is_moving()) {
			limb.mode = Actuation::LIMP;
		}
	}
}

bool ActuationTable::has_mode(Actuation p_mode) const {
	return std::any_of(
			_limbs.begin(), _limbs.end(), [p_mode](const LimbState &p_limb) { return p_limb.mode == p_mode; });
}

float ActuationTable::get_strength(std::size_t p_limb) const {
	const float lost = _overall.get() * _limbs[p_limb].flinch.get() * _scales[p_limb];
	return std::max(get_standing_strength(p_limb) * lost, LIMP_FRICTION);
}

float ActuationTable::get_standing_strength(std::size_t p_limb) const {
	const LimbState &limb = _limbs[p_limb];
	return _groups[limb.group].strength.get() * limb.authority.get() * limb.share.get();
}

void ActuationTable::set_limb_spring(
		float p_frequency, float p_damping_ratio, float p_usual, std::size_t p_limb, float p_blend_s) {
	LimbState &limb = _limbs[p_limb];
	if (p_frequency <= 0.0f) {
		limb.frequency = Ramp(0.0f);
		limb.damping_ratio = Ramp(0.0f);
		return;
	}
	if (limb.frequency.get() <= 0.0f) {
		limb.frequency = Ramp(p_usual);
		limb.damping_ratio = Ramp(p_damping_ratio);
	}
	limb.frequency.go(p_frequency, p_blend_s);
	limb.damping_ratio.go(p_damping_ratio, p_blend_s);
}

void ActuationTable::flinch(std::size_t p_limb, float p_strength, float p_blend_s) {
	Ramp &ramp = _limbs[p_limb].flinch;
	ramp = Ramp(std::min(ramp.get(), p_strength));
	ramp.go(1.0f, p_blend_s);
}

SpringSettings ActuationTable::get_spring(std::size_t p_limb) const {
	const LimbState &limb = _limbs[p_limb];
	const GroupSettings &group = _groups[limb.group];
	const bool is_own = limb.frequency.get() > 0.0f;
	return { is_own ? limb.frequency.get() : group.frequency, is_own ? limb.damping_ratio.get() : group.damping_ratio };
}

bool ActuationTable::is_blended() const {
	return std::any_of(_limbs.begin(), _limbs.end(), [](const LimbState &p_limb) { return p_limb.blend.get() < 1.0f; });
}

void ActuationTable::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(_limbs);
	p_archive.put_all(_groups);
	p_archive.put(_overall);
}

bool ActuationTable::restore(ArchiveReader &p_archive) {
	return p_archive.get_all(_limbs) && p_archive.get_all(_groups) && p_archive.get(_overall);
}

} // namespace ragdoll
