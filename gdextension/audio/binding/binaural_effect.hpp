// SPDX-License-Identifier: MIT
#pragma once

#include "binaural_head.hpp"

#include <binaural_filter.hpp>

#include <godot_cpp/classes/audio_effect.hpp>
#include <godot_cpp/classes/audio_effect_instance.hpp>
#include <godot_cpp/classes/audio_frame.hpp>
#include <godot_cpp/classes/ref.hpp>

#include <memory>
#include <mutex>
#include <vector>

namespace godot {

/// What the game's thread tells the mixer's: which filters to hear with.
struct EarsMailbox {
	std::mutex mutex;
	audio::Ears ears;
	bool has_news = false;
};

/// Lets a bus be heard from a direction. Documented in doc_classes/BinauralEffect.xml.
class BinauralEffect : public AudioEffect {
	GDCLASS(BinauralEffect, AudioEffect)

public:
	void set_head(const Ref<BinauralHead> &p_head);
	void set_direction(const Vector3 &p_direction);

	Ref<AudioEffectInstance> _instantiate() override;

protected:
	static void _bind_methods();

private:
	Ref<BinauralHead> _head;
	Vector3 _direction = Vector3(0.0f, 0.0f, -1.0f);
	bool _is_posted = false;
	std::shared_ptr<EarsMailbox> _mailbox = std::make_shared<EarsMailbox>();
};

/// The effect at work, in the mixer's thread.
class BinauralEffectInstance : public AudioEffectInstance {
	GDCLASS(BinauralEffectInstance, AudioEffectInstance)

public:
	void use(const std::shared_ptr<EarsMailbox> &p_mailbox) { _mailbox = p_mailbox; }

	void _process(const void *p_source, AudioFrame *p_target, int32_t p_frames) override;

protected:
	static void _bind_methods() {}

private:
	std::shared_ptr<EarsMailbox> _mailbox;
	audio::BinauralFilter _filter;
	bool _has_ears = false;
	std::vector<float> _mono;
};

} // namespace godot
