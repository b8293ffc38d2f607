// SPDX-License-Identifier: MIT
#include "pose_filter.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

constexpr int ENOUGH = 5; // Samples in a row that two third differences take, and one.
constexpr float NOISE_OF_PRODUCT = -1.0f / 45.0f; // See find_noise; three axes.
constexpr float EVEN = 0.2f; // Spans differ by less than this share.

} // namespace

void PoseFilter::clear() {
	known = 0;
	noise = 0.0f;
}

void PoseFilter::begin(const std::vector<Quat> &p_sampled) {
	for (std::size_t i = 0; i < limbs.size(); i++) {
		limbs[i].sampled = limbs[i].calm = p_sampled[i];
		limbs[i].rate = {};
	}
	known = 1;
}

void PoseFilter::find_noise(const std::vector<Quat> &p_sampled, float p_span_s) {
	// Successive third differences of white noise of variance s have a mean product of -15 s; those of
	// motion are alike, so that their product is positive: motion is not taken for noise. A blow looks
	// like noise, but not in half of the limbs.
	known = std::fabs(p_span_s - span) < EVEN * p_span_s ? std::min(known + 1, ENOUGH) : 1;
	span = p_span_s;
	const float fresh = share(p_span_s, NOISE_S);
	for (std::size_t i = 0; i < limbs.size(); i++) {
		Limb &limb = limbs[i];
		const Vec3 turned = log(limb.sampled.inverse() * p_sampled[i]);
		const Vec3 third = turned - limb.turned[0] * 2.0f + limb.turned[1];
		if (known == ENOUGH) {
			limb.product += fresh * (third.dot(limb.third) - limb.product);
		}
		limb.third = third;
		limb.turned[1] = limb.turned[0];
		limb.turned[0] = turned;
		limb.sampled = p_sampled[i];
		levels[i] = limb.product * NOISE_OF_PRODUCT;
	}
	const std::size_t middle = levels.size() / 2;
	std::nth_element(levels.begin(), levels.begin() + long(middle), levels.end());
	noise = std::sqrt(std::clamp(levels[middle] - CLEAN * CLEAN, 0.0f, NOISIEST * NOISIEST));
}

void PoseFilter::advance(const std::vector<Quat> &p_sampled, float p_span_s) {
	find_noise(p_sampled, p_span_s);
	for (std::size_t i = 0; i < limbs.size(); i++) {
		Limb &limb = limbs[i];
		const Quat expected = limb.calm * exp(limb.rate * p_span_s);
		const Vec3 off = log(expected.inverse() * p_sampled[i]);
		limb.surprises.advance(off.dot(off) / 3.0f, noise, p_span_s, SURPRISE_S, CALMEST);
		limb.calm = expected * exp(off * limb.surprises.get_gain());
		limb.rate = limb.rate + off * (limb.surprises.get_rate_gain() / p_span_s);
	}
}

void PoseFilter::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(limbs);
	p_archive.put(noise);
	p_archive.put(span);
	p_archive.put(known);
}

bool PoseFilter::restore(ArchiveReader &p_archive) {
	return p_archive.get_all(limbs) && p_archive.get(noise) && p_archive.get(span) && p_archive.get(known);
}

} // namespace ragdoll
