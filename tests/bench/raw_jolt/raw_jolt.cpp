// SPDX-License-Identifier: MIT
// Replays with Jolt alone what Jolt was told by the engine, and tells what a step takes and how far
// the bodies end from the engine's: raw_jolt RECORDING TICKS_TO_WARM_UP. Prints one JSON object.

#include "recording.hpp"

#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/JobSystemThreadPool.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/GroupFilter.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>
#include <Jolt/Physics/Collision/Shape/RotatedTranslatedShape.h>
#include <Jolt/Physics/Constraints/SixDOFConstraint.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>

namespace {

constexpr int TEMPORARY_BYTES = 32 * 1024 * 1024; // As the engine has it.

/// Everything moves, and everything collides but for limbs of one person.
class OneLayer final : public JPH::BroadPhaseLayerInterface {
public:
	JPH::uint GetNumBroadPhaseLayers() const override { return 1; }
	JPH::BroadPhaseLayer GetBroadPhaseLayer(JPH::ObjectLayer) const override { return JPH::BroadPhaseLayer(0); }
#if defined(JPH_EXTERNAL_PROFILE) || defined(JPH_PROFILE_ENABLED)
	const char *GetBroadPhaseLayerName(JPH::BroadPhaseLayer) const override { return "people"; }
#endif
};

class OtherPeople final : public JPH::GroupFilter {
public:
	bool CanCollide(const JPH::CollisionGroup &p_one, const JPH::CollisionGroup &p_other) const override {
		return p_one.GetGroupID() != p_other.GetGroupID();
	}
};

struct Figures {
	double p50_us = 0.0;
	double p99_us = 0.0;
	double mean_mm = 0.0;
	double max_mm = 0.0;
	double max_deg = 0.0;
};

JPH::Vec3 to_vec3(const float *p_numbers) {
	return JPH::Vec3(p_numbers[0], p_numbers[1], p_numbers[2]);
}

JPH::Quat to_quat(const float *p_numbers) {
	return JPH::Quat(p_numbers[0], p_numbers[1], p_numbers[2], p_numbers[3]).Normalized();
}

/// The people of a recording in a world of their own.
class World {
public:
	explicit World(const Recording &p_recording) : recording(p_recording) {
		people.SetEmbedded(); // Not to be freed with the last body that refers to it.
		const JPH::uint count = JPH::uint(p_recording.bodies.size());
		system.Init(count + 8, 0, 65536, 20480, broad_phase, broad_phase_filter, layer_filter);
		system.SetPhysicsSettings(make_settings());
		system.SetGravity(JPH::Vec3(0.0f, -p_recording.settings.gravity, 0.0f));
		system.SetCombineFriction(
				[](const JPH::Body &p_one, const JPH::SubShapeID &, const JPH::Body &p_other, const JPH::SubShapeID &) {
					return std::min(p_one.GetFriction(), p_other.GetFriction());
				});
		for (std::size_t i = 0; i < p_recording.bodies.size(); i++) {
			bodies.push_back(add_body(p_recording.bodies[i], i / p_recording.limbs));
		}
		joints.resize(bodies.size());
		for (std::size_t person = 0; person < p_recording.people; person++) {
			// From the leaves to the root: the order of making is the order of solving.
			for (std::size_t limb = p_recording.limbs; limb-- > 0;) {
				add_joint(person, limb);
			}
		}
		system.OptimizeBroadPhase();
	}

	/// Sets the motors for a tick.
	void aim(const float *p_targets) {
		for (std::size_t i = 0; i < joints.size(); i++) {
			const float *target = p_targets + i * Recording::JOINT_TARGETS;
			joints[i]->SetTargetAngularVelocityCS(to_vec3(target));
			for (int axis = JPH::SixDOFConstraintSettings::EAxis::RotationX;
					axis < JPH::SixDOFConstraintSettings::EAxis::Num; axis++) {
				joints[i]->GetMotorSettings(JPH::SixDOFConstraintSettings::EAxis(axis)).SetTorqueLimit(target[3]);
			}
		}
		const float *linear = p_targets + joints.size() * Recording::JOINT_TARGETS;
		for (std::size_t person = 0; person < recording.people; person++) {
			joints[person * recording.limbs]->SetTargetVelocityCS(to_vec3(linear + person * 3));
		}
	}

	bool step(JPH::TempAllocator &p_allocator, JPH::JobSystem &p_jobs) {
		return system.Update(1.0f / recording.hz, 1, &p_allocator, &p_jobs) == JPH::EPhysicsUpdateError::None;
	}

	/// How far the bodies are from where the engine had them in the end.
	void compare(Figures &r_figures) const {
		for (std::size_t i = 0; i < bodies.size(); i++) {
			const JPH::Vec3 off = JPH::Vec3(bodies[i]->GetPosition()) - to_vec3(recording.ends[i].position);
			const JPH::Quat turn = bodies[i]->GetRotation().Conjugated() * to_quat(recording.ends[i].rotation);
			const double sine = std::min(double(turn.GetXYZ().Length()), 1.0);
			r_figures.mean_mm += 1000.0 * off.Length() / double(bodies.size());
			r_figures.max_mm = std::max(r_figures.max_mm, 1000.0 * off.Length());
			r_figures.max_deg = std::max(r_figures.max_deg, 2.0 * std::asin(sine) * 180.0 / M_PI);
		}
	}

private:
	JPH::PhysicsSettings make_settings() const {
		const Recording::Settings &from = recording.settings;
		JPH::PhysicsSettings to;
		to.mNumVelocitySteps = JPH::uint(from.velocity_steps);
		to.mNumPositionSteps = JPH::uint(from.position_steps);
		to.mBaumgarte = from.baumgarte;
		to.mSpeculativeContactDistance = from.speculative_contact_distance;
		to.mPenetrationSlop = from.penetration_slop;
		to.mLinearCastThreshold = from.linear_cast_threshold;
		to.mLinearCastMaxPenetration = from.linear_cast_max_penetration;
		to.mBodyPairCacheMaxDeltaPositionSq = from.body_pair_distance * from.body_pair_distance;
		to.mBodyPairCacheCosMaxDeltaRotationDiv2 = std::cos(from.body_pair_angle / 2.0f);
		to.mMinVelocityForRestitution = from.bounce_velocity;
		return to;
	}

	JPH::ShapeRefC make_shape(const Recording::Body &p_body) const {
		JPH::ShapeRefC shape;
		if (p_body.is_capsule != 0.0f) {
			shape = JPH::CapsuleShapeSettings(p_body.size[1], p_body.size[0]).Create().Get();
		} else {
			const JPH::Vec3 half = to_vec3(p_body.size);
			const float margin = std::min(0.04f, half.ReduceMin() * recording.settings.margin_fraction);
			shape = JPH::BoxShapeSettings(half, margin).Create().Get();
		}
		const JPH::Vec3 position = to_vec3(p_body.shape.position);
		const JPH::Quat rotation = to_quat(p_body.shape.rotation);
		return JPH::RotatedTranslatedShapeSettings(position, rotation, shape).Create().Get();
	}

	JPH::Body *add_body(const Recording::Body &p_body, std::size_t p_person) {
		JPH::BodyCreationSettings settings(make_shape(p_body), JPH::RVec3(to_vec3(p_body.place.position)),
				to_quat(p_body.place.rotation), JPH::EMotionType::Dynamic, 0);
		settings.mCollisionGroup = JPH::CollisionGroup(&people, JPH::CollisionGroup::GroupID(p_person), 0);
		settings.mMotionQuality = JPH::EMotionQuality::LinearCast;
		settings.mEnhancedInternalEdgeRemoval = true;
		settings.mAllowSleeping = false;
		settings.mFriction = p_body.friction;
		settings.mLinearDamping = 0.0f;
		settings.mAngularDamping = 0.0f;
		settings.mMaxLinearVelocity = recording.settings.max_linear_velocity;
		settings.mMaxAngularVelocity = recording.settings.max_angular_velocity;
		settings.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
		settings.mMassPropertiesOverride.mMass = p_body.mass;
		settings.mMassPropertiesOverride.mInertia = JPH::Mat44::sScale(to_vec3(p_body.inertia));
		JPH::BodyInterface &interface = system.GetBodyInterfaceNoLock();
		JPH::Body *body = interface.CreateBody(settings);
		interface.AddBody(body->GetID(), JPH::EActivation::Activate);
		return body;
	}

	void add_joint(std::size_t p_person, std::size_t p_limb) {
		using Settings = JPH::SixDOFConstraintSettings;
		const std::size_t index = p_person * recording.limbs + p_limb;
		const Recording::Joint &joint = recording.joints[index];
		const bool is_root = joint.parent < 0.0f;
		Settings settings;
		settings.mSpace = JPH::EConstraintSpace::LocalToBodyCOM;
		settings.mSwingType = JPH::ESwingType::Pyramid;
		settings.mPosition1 = JPH::RVec3(to_vec3(joint.frame_a.position));
		settings.mAxisX1 = to_quat(joint.frame_a.rotation).RotateAxisX();
		settings.mAxisY1 = to_quat(joint.frame_a.rotation).RotateAxisY();
		settings.mPosition2 = JPH::RVec3(to_vec3(joint.frame_b.position));
		settings.mAxisX2 = to_quat(joint.frame_b.rotation).RotateAxisX();
		settings.mAxisY2 = to_quat(joint.frame_b.rotation).RotateAxisY();
		for (int axis = 0; axis < Settings::EAxis::Num; axis++) {
			const bool is_linear = axis < Settings::EAxis::RotationX;
			if (is_linear && !is_root) {
				settings.SetLimitedAxis(Settings::EAxis(axis), 0.0f, 0.0f);
				continue;
			}
			settings.MakeFreeAxis(Settings::EAxis(axis));
			if (is_linear) {
				settings.mMotorSettings[axis].SetForceLimit(joint.force);
			}
		}
		JPH::Body &body = *bodies[index];
		JPH::Body &parent =
				is_root ? JPH::Body::sFixedToWorld : *bodies[p_person * recording.limbs + std::size_t(joint.parent)];
		joints[index] = static_cast<JPH::SixDOFConstraint *>(settings.Create(parent, body));
		for (int axis = is_root ? 0 : int(Settings::EAxis::RotationX); axis < Settings::EAxis::Num; axis++) {
			joints[index]->SetMotorState(Settings::EAxis(axis), JPH::EMotorState::Velocity);
		}
		system.AddConstraint(joints[index]);
	}

	const Recording &recording;
	OneLayer broad_phase;
	JPH::ObjectVsBroadPhaseLayerFilter broad_phase_filter;
	JPH::ObjectLayerPairFilter layer_filter;
	OtherPeople people;
	JPH::PhysicsSystem system;
	std::vector<JPH::Body *> bodies;
	std::vector<JPH::Ref<JPH::SixDOFConstraint>> joints;
};

double percentile(std::vector<double> &r_sorted, double p_fraction) {
	std::sort(r_sorted.begin(), r_sorted.end());
	const double place = std::ceil(p_fraction * double(r_sorted.size())) - 1.0;
	return r_sorted.empty() ? 0.0 : r_sorted[std::size_t(std::max(place, 0.0))];
}

/// Replays everything. Returns whether Jolt had room for all contacts.
bool replay(const Recording &p_recording, std::size_t p_warm_up, JPH::JobSystem &p_jobs, Figures &r_figures) {
	using Clock = std::chrono::steady_clock;
	JPH::TempAllocatorImpl allocator(TEMPORARY_BYTES);
	const std::unique_ptr<World> world = std::make_unique<World>(p_recording);
	std::vector<double> times;
	bool is_good = true;
	for (std::size_t tick = 0; tick < p_recording.ticks; tick++) {
		world->aim(p_recording.targets.data() + tick * p_recording.tick_size());
		const Clock::time_point begin = Clock::now();
		is_good = world->step(allocator, p_jobs) && is_good;
		if (tick >= p_warm_up) {
			times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
		}
	}
	r_figures.p50_us = percentile(times, 0.5);
	r_figures.p99_us = percentile(times, 0.99);
	world->compare(r_figures);
	return is_good;
}

void print(const char *p_name, const Figures &p_figures) {
	std::printf(R"("%s":{"p50_us":%.2f,"p99_us":%.2f,"mean_mm":%.5f,"max_mm":%.5f,"max_deg":%.5f})", p_name,
			p_figures.p50_us, p_figures.p99_us, p_figures.mean_mm, p_figures.max_mm, p_figures.max_deg);
}

} // namespace

int main(int p_count, char **p_arguments) {
	if (p_count != 3) {
		std::fprintf(stderr, "usage: raw_jolt RECORDING TICKS_TO_WARM_UP\n");
		return 2;
	}
	Recording recording;
	const std::string fault = recording.read(p_arguments[1]);
	if (!fault.empty()) {
		std::fprintf(stderr, "%s\n", fault.c_str());
		return 2;
	}
	const std::size_t warm_up = std::size_t(std::max(std::atoi(p_arguments[2]), 0));
	JPH::RegisterDefaultAllocator();
	JPH::Factory::sInstance = new JPH::Factory();
	JPH::RegisterTypes();
	const int threads = std::max(int(std::thread::hardware_concurrency()), 1);
	Figures one;
	Figures all;
	bool is_good = false;
	{
		JPH::JobSystemSingleThreaded single(JPH::cMaxPhysicsJobs);
		// This thread works too.
		JPH::JobSystemThreadPool pool(JPH::cMaxPhysicsJobs, JPH::cMaxPhysicsBarriers, threads - 1);
		is_good = replay(recording, warm_up, single, one);
		is_good = replay(recording, warm_up, pool, all) && is_good;
	}
	std::printf(
			R"({"jolt":"%d.%d.%d","threads":%d,)", JPH_VERSION_MAJOR, JPH_VERSION_MINOR, JPH_VERSION_PATCH, threads);
	print("one", one);
	std::printf(",");
	print("all", all);
	std::printf("}\n");
	JPH::UnregisterTypes();
	delete JPH::Factory::sInstance;
	JPH::Factory::sInstance = nullptr;
	if (!is_good) {
		std::fprintf(stderr, "Jolt had too little room for contacts\n");
	}
	return is_good ? 0 : 1;
}
