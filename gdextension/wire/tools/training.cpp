// SPDX-License-Identifier: MIT
#include "training.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace training {

using namespace wire;

namespace {

constexpr int RESOLUTIONS[2] = { PersonLattice::FINE, PersonLattice::COARSE };

// A port that counts bits.
class CostPort {
public:
	CostPort() {
		for (int i = 1; i <= 65536; i++) {
			_costs[std::size_t(i)] = float(16.0 - std::log2(double(i)));
		}
	}
	bool number(const NumberModel &p_model, int64_t &p_number) {
		const NumberSymbols symbols(p_model);
		const int64_t index = symbols.index_of(p_number);
		const int64_t away = symbols.bucket_of(index);
		constexpr int64_t MAX = NumberSymbols::MAX_BUCKETS;
		const int bucket = int(away < -MAX ? -MAX : (away > MAX ? MAX : away));
		sum += _costs[symbols.below(bucket + 1) - symbols.below(bucket)];
		if (bucket == MAX || bucket == -MAX) {
			sum += 5.0 + std::floor(std::log2(double((away < 0 ? -away : away) - MAX + 1)));
		}
		sum += symbols.shift;
		return true;
	}
	bool bit(uint32_t p_zero, bool &p_one) {
		sum += _costs[p_one ? 65536 - p_zero : p_zero];
		return true;
	}
	bool bits(int p_count, uint32_t &) {
		sum += p_count;
		return true;
	}

	double sum = 0.0;

private:
	std::array<float, 65537> _costs{};
};

using States = std::vector<std::vector<PersonState>>;

States quantise(const std::vector<Clip> &p_clips, int p_resolution) {
	const PersonLattice lattice(p_resolution);
	const Skeleton body = skeleton();
	States all;
	for (const Clip &clip : p_clips) {
		std::vector<PersonState> states(clip.size());
		for (std::size_t i = 0; i < clip.size(); i++) {
			lattice.quantise(clip[i], body, i > 0 ? &states[i - 1] : nullptr, states[i]);
		}
		all.push_back(std::move(states));
	}
	return all;
}

struct Sample {
	const PersonState *now;
	const PersonState *base;
	const PersonState *before;
	int base_age;
	int velocity_age;
};

using Samples = std::vector<Sample>;

// How far apart base and the one before it may be, as often as here.
constexpr int VELOCITY_AGES[8] = { 2, 2, 1, 2, 4, 2, 1, 2 };

Samples sample(const States &p_states, int p_age, bool p_moving, int p_stride) {
	Samples samples;
	for (const std::vector<PersonState> &states : p_states) {
		int turn = 0;
		for (std::size_t now = std::size_t(p_age) + 8; now < states.size(); now += std::size_t(p_stride)) {
			const int velocity_age = VELOCITY_AGES[turn++ % 8];
			const PersonState *base = &states[now - std::size_t(p_age)];
			samples.push_back({ &states[now], p_age > 0 ? base : nullptr, p_moving ? base - velocity_age : nullptr,
					p_age, velocity_age });
		}
	}
	return samples;
}

class Trainer {
public:
	Trainer(const uint16_t (*p_shares)[SHARE_POINTS], const Samples &p_samples, int p_resolution) :
			_shares(p_shares), _samples(p_samples), _resolution(p_resolution), _body(skeleton()) {}

	// Bits of a person.
	double cost(const PersonModel &p_model) {
		_port.sum = 0.0;
		for (const Sample &sample : _samples) {
			const PersonContext context{ p_model, _shares, _body, _resolution, sample.base, sample.before,
				sample.base_age, sample.velocity_age };
			PersonState state = *sample.now;
			PersonCoder<CostPort>(_port, context).code_changed(state);
		}
		return _port.sum / double(_samples.size());
	}

	// Changes one parameter after the other as long as it helps.
	void improve(PersonModel &r_model) {
		int16_t *parameters = reinterpret_cast<int16_t *>(&r_model);
		constexpr int COUNT = int(sizeof(PersonModel) / sizeof(int16_t));
		double best = cost(r_model);
		std::vector<int> steps(std::size_t(COUNT), 16);
		for (int round = 0; round < 12; round++) {
			const double start = best;
			for (int i = 0; i < COUNT; i++) {
				best = _improve_one(r_model, parameters[i], _is_shape(i), _is_weight(i), steps[std::size_t(i)], best);
			}
			if (start - best < 0.02 && round > 5) {
				break;
			}
		}
	}

private:
	static bool _is_shape(int p_parameter) {
		constexpr int COUNT = int(sizeof(MotionModel) / sizeof(int16_t));
		return p_parameter % COUNT >= COUNT - 3;
	}
	// A divisor: MotionModel::along.
	static bool _is_weight(int p_parameter) {
		constexpr int COUNT = int(sizeof(MotionModel) / sizeof(int16_t));
		return p_parameter % COUNT == COUNT - 4;
	}
	double _improve_one(
			PersonModel &r_model, int16_t &r_parameter, bool p_shape, bool p_positive, int &r_step, double p_best) {
		const int16_t old = r_parameter;
		const int step = p_shape ? 1 : r_step;
		for (const int change : { step, -step }) {
			const int wanted = old + change;
			if ((p_shape && (wanted < 0 || wanted >= SHAPES)) || (p_positive && wanted < 0)) {
				continue;
			}
			r_parameter = int16_t(wanted);
			const double found = cost(r_model);
			if (found < p_best - 1e-9) {
				r_step = r_step < 64 ? r_step * 3 / 2 + 1 : r_step;
				return found;
			}
		}
		r_parameter = old;
		r_step = r_step > 1 ? r_step / 2 : 1;
		return p_best;
	}

	const uint16_t (*_shares)[SHARE_POINTS];
	const Samples &_samples;
	int _resolution;
	Skeleton _body;
	CostPort _port;
};

MotionModel start_motion(int p_bias, int p_gain, bool p_moving) {
	MotionModel model{};
	for (int16_t &gain : model.gains) {
		gain = int16_t(p_moving ? p_gain : 0);
	}
	for (int16_t &bias : model.biases) {
		bias = int16_t(p_bias);
	}
	model.speed = p_moving ? 24 : 0;
	model.part_speed = p_moving ? 16 : 0;
	model.parent = 8;
	model.average = 16;
	model.part = 16;
	model.along = 512;
	for (int16_t &shape : model.shapes) {
		shape = 4;
	}
	return model;
}

PersonModel start_model(int p_age, bool p_moving) {
	if (p_age == 0) {
		return { start_motion(255, 0, false), start_motion(180, 0, false) };
	}
	const int gain = p_age > 8 ? 32 : 256 - 28 * p_age;
	return { start_motion(20 + 4 * p_age, gain, p_moving), start_motion(20 + 4 * p_age, gain, p_moving) };
}

PersonModel train(
		const States &p_states, const Models &p_models, int p_precision, int p_age, bool p_moving, int p_stride) {
	const Samples samples = sample(p_states, p_age, p_moving, p_stride);
	Trainer trainer(p_models.shares, samples, RESOLUTIONS[p_precision]);
	PersonModel model = start_model(p_age, p_moving);
	trainer.improve(model);
	std::fprintf(stderr, "resolution %d age %d %s: %.1f bits\n", RESOLUTIONS[p_precision], p_age,
			p_moving ? "moving" : "still", trainer.cost(model));
	return model;
}

// Share of Student's distribution within a point, to one side; degrees of freedom 0: Gauss.
void fill_shares(double p_freedom, uint16_t *r_shares) {
	constexpr int FINE_STEPS = 64;
	const auto density = [&](double p_point) {
		return p_freedom <= 0.0 ? std::exp(-0.5 * p_point * p_point)
								: std::pow(1.0 + p_point * p_point / p_freedom, -0.5 * (p_freedom + 1.0));
	};
	std::vector<double> sums{ 0.0 };
	const double step = 1.0 / (16.0 * FINE_STEPS);
	const int count = 16 * FINE_STEPS * 400;
	for (int i = 0; i < count; i++) {
		sums.push_back(sums.back() + step * density((i + 0.5) * step));
	}
	constexpr double HALF = 32768 - NumberSymbols::MAX_BUCKETS - 1;
	for (int i = 0; i < SHARE_POINTS; i++) {
		r_shares[i] = uint16_t(std::lround(HALF * sums[std::size_t(i) * FINE_STEPS] / sums.back()));
	}
}

void fill_all_shares(Models &r_models) {
	constexpr double FREEDOMS[SHAPES] = { 1.2, 1.6, 2.2, 3.0, 4.5, 7.0, 14.0, 0.0 };
	for (int i = 0; i < SHAPES; i++) {
		fill_shares(FREEDOMS[i], r_models.shares[i]);
	}
}

} // namespace

Skeleton skeleton() {
	Skeleton body;
	body.limb_count = 16;
	constexpr int PARENTS[16] = { -1, 0, 1, 2, 2, 4, 5, 2, 7, 8, 0, 10, 11, 0, 13, 14 };
	for (std::size_t i = 0; i < 16; i++) {
		body.parents[i] = PARENTS[i];
	}
	return body;
}

std::vector<Clip> read_clips(const char *p_path) {
	std::vector<Clip> clips;
	std::FILE *file = std::fopen(p_path, "rb");
	uint32_t ticks = 0;
	while (file != nullptr && std::fread(&ticks, 4, 1, file) == 1) {
		Clip clip;
		float values[67];
		while (ticks-- > 0 && std::fread(values, sizeof(values), 1, file) == 1) {
			kinematics::PersonPose pose;
			pose.root = { values[0], values[1], values[2] };
			for (std::size_t i = 0; i < 16; i++) {
				const float *q = values + 3 + 4 * i;
				pose.orientations[i] = kinematics::Quat{ q[0], q[1], q[2], q[3] };
			}
			clip.push_back(pose);
		}
		clips.push_back(std::move(clip));
	}
	if (file != nullptr) {
		std::fclose(file);
	}
	return clips;
}

Models train_all(const std::vector<Clip> &p_clips) {
	constexpr int AGES[AGE_STEPS] = { 1, 2, 4, 6, 8, 12, 19, 40 };
	Models models{};
	fill_all_shares(models);
	for (int precision = 0; precision < 2; precision++) {
		const States states = quantise(p_clips, RESOLUTIONS[precision]);
		models.whole[precision] = train(states, models, precision, 0, false, 11);
		for (int i = 0; i < AGE_STEPS; i++) {
			// The ages that most receivers have get most of the time.
			const int stride = AGES[i] <= 2 || AGES[i] == 6 ? 3 : 7;
			models.still[precision][i] = train(states, models, precision, AGES[i], false, 7);
			models.moving[precision][i] = train(states, models, precision, AGES[i], true, stride);
		}
	}
	return models;
}

void report_left_out(const std::vector<Clip> &p_clips) {
	Models models{};
	fill_all_shares(models);
	for (int precision = 0; precision < 2; precision++) {
		for (const int age : { 2, 6 }) {
			double shipped = 0.0;
			double left_out = 0.0;
			const States all = quantise(p_clips, RESOLUTIONS[precision]);
			const PersonModel common = train(all, models, precision, age, true, 3);
			for (std::size_t i = 0; i < p_clips.size(); i++) {
				std::vector<Clip> others = p_clips;
				others.erase(others.begin() + std::ptrdiff_t(i));
				const PersonModel other =
						train(quantise(others, RESOLUTIONS[precision]), models, precision, age, true, 3);
				const States own{ all[i] };
				const Samples samples = sample(own, age, true, 1);
				Trainer trainer(models.shares, samples, RESOLUTIONS[precision]);
				shipped += trainer.cost(common) / double(p_clips.size());
				left_out += trainer.cost(other) / double(p_clips.size());
			}
			// Half a byte or so to end it.
			std::printf("resolution %d, base %d ticks old: %.1f bits, left out %.1f; at 30 Hz %.2f and %.2f kbit/s\n",
					RESOLUTIONS[precision], age, shipped, left_out, 0.03 * (shipped + 8.0), 0.03 * (left_out + 8.0));
		}
	}
}

} // namespace training
