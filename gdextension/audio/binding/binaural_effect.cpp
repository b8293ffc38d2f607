// SPDX-License-Identifier: MIT
#include "binaural_effect.hpp"

#include <cstddef>

namespace godot {

static_assert(sizeof(AudioFrame) == 2 * sizeof(float), "Both ears lie side by side.");

namespace {

/// A direction that has changed by less is the same: a quarter of a degree, which nobody hears.
constexpr float SAME = 1e-5f;

} // namespace

void BinauralEffect::set_head(const Ref<BinauralHead> &p_head) {
	_head = p_head;
	_is_posted = false;
	set_direction(_direction);
}

void BinauralEffect::set_direction(const Vector3 &p_direction) {
	if (_head.is_null() || !_head->is_open()) {
		_direction = p_direction;
		return;
	}
	const Vector3 way = p_direction.normalized();
	if (_is_posted && way.dot(_direction) > 1.0f - SAME) {
		return;
	}
	_direction = way;
	_is_posted = true;
	const audio::Ears ears = _head->head().find(float(way.x), float(way.y), float(way.z));
	const std::lock_guard<std::mutex> lock(_mailbox->mutex);
	_mailbox->ears = ears;
	_mailbox->has_news = true;
}

Ref<AudioEffectInstance> BinauralEffect::_instantiate() {
	Ref<BinauralEffectInstance> instance;
	instance.instantiate();
	instance->use(_mailbox);
	return instance;
}

void BinauralEffect::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_head", "head"), &BinauralEffect::set_head);
	ClassDB::bind_method(D_METHOD("set_direction", "direction"), &BinauralEffect::set_direction);
}

void BinauralEffectInstance::_process(const void *p_source, AudioFrame *p_target, int32_t p_frames) {
	if (p_frames <= 0 || p_source == nullptr || p_target == nullptr) {
		return;
	}
	// The mixer must not wait: what is being written now is heard a block later.
	if (_mailbox != nullptr && _mailbox->mutex.try_lock()) {
		if (_mailbox->has_news || !_has_ears) {
			_filter.set_ears(_mailbox->ears);
			_mailbox->has_news = false;
			_has_ears = true;
		}
		_mailbox->mutex.unlock();
	}
	const auto *source = static_cast<const AudioFrame *>(p_source);
	const auto frames = std::size_t(p_frames);
	_mono.resize(frames);
	for (std::size_t i = 0; i < frames; i++) {
		_mono[i] = 0.5f * (source[i].left + source[i].right);
	}
	_filter.process(_mono.data(), &p_target->left, frames);
}

} // namespace godot
