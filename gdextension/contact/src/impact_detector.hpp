// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace contact {

/// What touches what: numbers of two bodies, the smaller one first.
struct Pair {
	std::uint64_t first = 0;
	std::uint64_t second = 0;

	bool operator==(const Pair &p_other) const { return first == p_other.first && second == p_other.second; }
};

/// A contact of two bodies in one step of the physics.
struct Touch {
	Pair pair;
	float impulse = 0.0f; ///< Along the normal, N s.
	float mass = 1.0f; ///< Of the body that was asked, kg.
	float slip = 0.0f; ///< How fast the surfaces slide over one another, m/s.
	std::size_t tag = 0; ///< The caller's own.
};

/// Something to be heard.
struct Impact {
	Pair pair;
	float impulse = 0.0f; ///< N s; of a scrape, within one step.
	float slip = 0.0f; ///< m/s; 0 for an impact, more for a scrape.
	std::size_t tag = 0; ///< That of its strongest touch.
};

/// Finds impacts and scrapes among the contacts of each step.
///
/// An impact is a contact that was not there a tenth of a second ago, or that presses much harder than it has until
/// now. What rests, rolls or is carried is none. Within 50 ms a pair has one, unless another is much stronger.
class ImpactDetector {
public:
	static constexpr float MIN_SPEED =
			0.35f; ///< Least change of speed of an impact, m/s: more than gravity's in a step.
	static constexpr float MIN_SLIP = 0.25f; ///< Least speed of a scrape, m/s.
	static constexpr int APART_STEPS = 6; ///< Bodies that have not touched for so long meet anew.
	static constexpr int MERGED_STEPS = 3; ///< Impacts of a pair within this are one.
	static constexpr int SCRAPE_STEPS = 6; ///< A scrape is told so often.

	/// Takes all contacts of a step; returns at most so many, the strongest first.
	std::vector<Impact> advance(const std::vector<Touch> &p_touches, std::size_t p_most);
	/// Forgets the pairs of a body.
	void forget(std::uint64_t p_body);
	std::size_t pair_count() const { return _pairs.size(); }

private:
	struct Hash {
		std::size_t operator()(const Pair &p_pair) const;
	};
	struct State {
		int seen = -1; ///< Step of the last contact.
		int begun = 0; ///< Step since which they touch.
		int told = -1000; ///< Step of the last impact.
		int scraped = -1000;
		float told_impulse = 0.0f;
		float support = 0.0f; ///< What the contact bears on average, N s a step.
	};
	struct Sum {
		float impulse = 0.0f;
		float strongest = -1.0f;
		float mass = 1.0f;
		float slip = 0.0f;
		std::size_t tag = 0;
	};

	bool _is_impact(State &r_state, const Sum &p_sum) const;
	bool _is_scrape(State &r_state, const Sum &p_sum) const;
	void _drop_old();

	std::unordered_map<Pair, State, Hash> _pairs;
	std::unordered_map<Pair, Sum, Hash> _sums;
	int _step = 0;
};

} // namespace contact
