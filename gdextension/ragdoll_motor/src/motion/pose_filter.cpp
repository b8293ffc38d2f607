// SPDX-License-Identifier: MIT
#include "motion/pose_filter.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

constexpr int ENOUGH = 5; // Samples in a row that two third differences take, and one.
constexpr float NOISE_OF_PRODUCT = -1.0f / 45.0f; // See find_noise; three axes.
constexpr float EVEN = 0.2f; // Spans differ by less than this share.

} // namespace

void PoseFilter::clear() {
	_known = 0;
	_noise = 0.0f;
}

void PoseFilter::begin(const std::vector<Quat> &p_sampled) {
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		_limbs[i].sampled = _limbs[i].calm = p_sampled[i];
		_limbs[i].rate = {};
	}
	_known = 1;
}

void PoseFilter::find_noise(const std::vector<Quat> &p_sampled, float p_span_s) {
	// Successive third differences of white noise of variance s have a mean product of -15 s; those of
	// motion are alike, so that their product is positive: motion is not taken for noise. A blow looks
	// like noise, but not in half of the limbs.
	_known = std::fabs(p_span_s - _span) < EVEN * p_span_s ? std::min(_known + 1, ENOUGH) : 1;
	_span = p_span_s;
	const float fresh = share(p_span_s, NOISE_S);
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		Limb &limb = _limbs[i];
		const Vec3 turned = log(limb.sampled.inverse() * p_sampled[i]);
		const Vec3 third = turned - limb.turned[0] * 2.0f + limb.turned[1];
		if (_known == ENOUGH) {
			limb.product += fresh * (third.dot(limb.third) - limb.product);
		}
		limb.third = third;
		limb.turned[1] = limb.turned[0];
		limb.turned[0] = turned;
		limb.sampled = p_sampled[i];
		_levels[i] = limb.product * NOISE_OF_PRODUCT;
	}
	const std::size_t middle = _levels.size() / 2;
	std::nth_element(_levels.begin(), _levels.begin() + long(middle), _levels.end());
	_noise = std::sqrt(std::clamp(_levels[middle] - CLEAN * CLEAN, 0.0f, NOISIEST * NOISIEST));
}

void PoseFilter::advance(const std::vector<Quat> &p_sampled, float p_span_s) {
	find_noise(p_sampled, p_span_s);
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		Limb &limb = _limbs[i];
		const Quat expected = limb.calm * exp(limb.rate * p_span_s);
		const Vec3 off = log(expected.inverse() * p_sampled[i]);
		limb.surprises.advance(off.dot(off) / 3.0f, _noise, p_span_s, SURPRISE_S, CALMEST);
		limb.calm = expected * exp(off * limb.surprises.get_gain());
		limb.rate = limb.rate + off * (limb.surprises.get_rate_gain() / p_span_s);
	}
}

void PoseFilter::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(_limbs);
	p_archive.put(_noise);
	p_archive.put(_span);
	p_archive.put(_known);
}

bool PoseFilter::restore(ArchiveReader &p_archive) {
	return p_archive.get_all(_limbs) && p_archive.get(_noise) && p_archive.get(_span) && p_archive.get(_known);
}

} // namespace ragdoll
