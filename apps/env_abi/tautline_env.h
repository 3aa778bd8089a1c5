/* The environment of `tautline learn train` for other programs and other languages: a robot that drags a cable, on the
 * task of a scene file. Plain C; link with libtautline_env.so or load it.
 *
 * Null pointers, and environments that are none or were freed, are refused and never followed, and so are steps outside
 * of an episode and actions that do not exist; other pointers must lead to as much room as is said. Nothing throws. One
 * environment is for one thread at a time; several are independent.
 *
 *   tautline_env *env = tautline_env_create("scene.yaml", NULL);
 *   float at[TAUTLINE_ENV_INPUTS];
 *   tautline_env_step_result step;
 *   if (env == NULL || tautline_env_reset(env, 1, at) != 0) puts(tautline_env_error());
 *   while (tautline_env_step(env, TAUTLINE_ENV_STRAIGHT, &step) == 0 && !step.terminated && !step.truncated) ...
 *   tautline_env_free(env);
 */
/* NOLINTBEGIN(modernize-*,readability-identifier-naming): this is C. */
#ifndef TAUTLINE_ENV_H_
#define TAUTLINE_ENV_H_

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Grows when a function or a struct changes its meaning; tautline_env_version() tells that of the library. */
#define TAUTLINE_ENV_VERSION 1
/** Numbers in an observation: x, y and heading of the robot, rounded; in [-1, 1] unless metres were asked for. */
#define TAUTLINE_ENV_INPUTS 3
/** Actions: 0 turns right, 1 goes straight, 2 turns left. */
#define TAUTLINE_ENV_ACTIONS 3
/** Turn right on the spot. */
#define TAUTLINE_ENV_RIGHT 0
/** Go straight. */
#define TAUTLINE_ENV_STRAIGHT 1
/** Turn left on the spot. */
#define TAUTLINE_ENV_LEFT 2

/** An environment; what is in it is no business of callers. */
typedef struct tautline_env tautline_env;

/** What a step did. Flags are 0 or 1. */
typedef struct tautline_env_step_result {
  float observation[TAUTLINE_ENV_INPUTS]; /**< The state after it. */
  double reward;                          /**< What it was worth. */
  int32_t terminated;                     /**< The goal was reached or an obstacle was hit: the episode is over. */
  int32_t truncated;                      /**< The steps are used up: the episode is cut. */
  int32_t at_goal;                        /**< The goal was reached. */
  int32_t robot_obstacle;                 /**< The robot hit an obstacle. */
  int32_t cable_obstacle;                 /**< The cable touches an obstacle. */
  int32_t cable_robot;                    /**< The robot stands on its cable. */
  int32_t held;                           /**< The cable was too short for the motion: nothing moved. */
} tautline_env_step_result;

/** Where the robot is, metres and radians. */
typedef struct tautline_env_pose {
  double x;       /**< Of its centre. */
  double y;       /**< Of its centre. */
  double heading; /**< Counter-clockwise from the x axis, in (-pi, pi]. */
} tautline_env_pose;

/** TAUTLINE_ENV_VERSION of the library. */
int32_t tautline_env_version(void);

/** What was wrong with the last call of this thread that failed; "" before the first. Valid until the next call of this
 * thread. Never null. */
const char* tautline_env_error(void);

/** An environment from a scene file, with the reference path that the exact engine finds, and the options of
 * `tautline learn train` as JSON: {"reward_cable_robot": -1, "observation": "metres", "use_reference": false}; names
 * have _ where options have -. Null options: the defaults. Null where something is wrong. */
tautline_env* tautline_env_create(const char* scene_path, const char* options_json);

/** Frees an environment; null is fine. */
void tautline_env_free(tautline_env* env);

/** Starts an episode and writes TAUTLINE_ENV_INPUTS numbers; `observation` may be null. The seed matters only with
 * noise. 0, or -1 where something is wrong. */
int32_t tautline_env_reset(tautline_env* env, uint64_t seed, float* observation);

/** One step. 0, or -1 where something is wrong: no episode is running, or there is no such action. */
int32_t tautline_env_step(tautline_env* env, int32_t action, tautline_env_step_result* result);

/** The state again. 0, or -1 where something is wrong. */
int32_t tautline_env_observe(const tautline_env* env, float* observation);

/** Where the robot is. 0, or -1 where something is wrong. */
int32_t tautline_env_where(const tautline_env* env, tautline_env_pose* pose);

/** The cable from base to tail: writes at most `room` points as x, y, x, y, ... and returns how many there are; null
 * `points` only counts. -1 where something is wrong. */
int64_t tautline_env_cable(const tautline_env* env, double* points, size_t room);

/** The goal and its radius: 3 numbers. 0, or -1 where something is wrong. */
int32_t tautline_env_goal(const tautline_env* env, double* goal);

#ifdef __cplusplus
}
#endif

#endif /* TAUTLINE_ENV_H_ */
/* NOLINTEND(modernize-*,readability-identifier-naming) */
