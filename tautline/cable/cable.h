// A cable on a floor: a chain of nodes that lies where it was dragged, held by obstacles and pulled by a robot.
#ifndef TAUTLINE_CABLE_CABLE_H_
#define TAUTLINE_CABLE_CABLE_H_

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/cable/strand.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// What pays the cable out at the base, and takes it in.
enum class Reel {
  kFree,        ///< Gives what is pulled from it, up to the length of the cable, and takes nothing back.
  kRetracting,  ///< Keeps the cable taut at all times. [Igarashi2010, Sec. 4.2]
};

/// How a cable is made.
struct CableOptions {
  double length_m = 0;           ///< All of it, with what is on the reel. Positive and finite.
  double link_length_m = 0.05;   ///< Along the cable from node to node. Positive; at most 1e6 of them.
  double robot_radius_m = 0.17;  ///< The disc that touches the cable; 0: only its centre does.
  Reel reel = Reel::kFree;       ///< What is at the base.
};

/// What became of a motion.
enum class StepOutcome {
  kMoved,    ///< The robot is where it was told to go.
  kBlocked,  ///< The straight way there leaves the free space; nothing moved.
  kHeld,     ///< The taut cable would be longer than the cable is; nothing moved.
};

/// What began to touch the cable.
enum class ContactKind {
  kObstacle,  ///< A corner of the free space holds the cable.
  kRobot,     ///< The robot drives over its own cable.
};

/// A touch that began in a step and had not lasted since the step before.
struct Contact {
  ContactKind kind;   ///< What touches the cable.
  double time_s = 0;  ///< The end of the step in which it began.
  Point at;           ///< The corner, or the point of the cable nearest to the robot's centre.
  VertexId corner;    ///< The vertex of the mesh; invalid for the robot.
};

/// What a step did.
struct StepResult {
  StepOutcome outcome = StepOutcome::kMoved;  ///< Whether it happened.
  std::size_t new_contacts = 0;               ///< So many entries at the end of Cable::contacts() are of this step.
  bool touches_obstacle = false;              ///< Some corner holds the cable after the step.
  bool touches_robot = false;                 ///< The robot stands on its cable after the step.
};

/// A cable from its base to the robot. Node 0 is at the base, the last one is the robot. Links have the option's length
/// except the first, which grows as the reel pays out. A link is string, not a rod: its nodes may come nearer to each
/// other, and its slack then lies between them; it is never longer than its length by more than a thousandth of a link.
/// Between its nodes it runs taut around the corners that hold it. Nodes and links stay in the closed free space, and
/// the class of the chain is that of the way which the robot drove: both exactly, since every motion slides nodes along
/// links. Deterministic. A copy goes on independently, so controllers may try motions on copies. [Shimada2024,
/// Sec. 5.2]
class Cable {
 public:
  /// The robot at the base and the whole cable on the reel. InvalidInput when a number makes no sense or the base is
  /// not in the free space. Keeps a reference to `space`.
  static Expected<Cable> Create(const TautSpace& space, Point base, const CableOptions& options);

  /// The cable laid along a polyline from base to robot, and the rest of it on the reel. As Create, and InvalidInput
  /// when the polyline is empty, leaves the free space or is longer than the cable. O(length of the polyline in
  /// triangles and nodes).
  static Expected<Cable> Lay(const TautSpace& space, std::span<const Point> polyline, const CableOptions& options);

  /// The robot drives straight to a point in dt_s seconds, and the cable follows: every node that the robot pulls, and,
  /// where the pull has come to the base and the reel is empty, all of them until the links fit again: README.md says
  /// how. Requires a finite point and dt_s >= 0. O(nodes moved) and O(nodes) for contacts; O(triangles along the cable)
  /// more where the reel is empty. [Shimada2024, Eqs. 6, 7]
  StepResult Step(Point to, double dt_s);

  /// The reel pulls in up to this many metres: the nodes follow from the base until the cable is taut, and the robot
  /// stands. Says how much came in. O(nodes).
  double Retract(double length_m);

  /// The reel pulls in all that it can: the cable lies taut. Says how much came in. O(triangles along the cable and
  /// nodes).
  double RetractAll() { return Retract(paid_out_m()); }

  /// The nodes from base to robot, each with a triangle that holds it.
  std::span<const Place> nodes() const { return nodes_; }
  /// The links; link i lies between nodes i and i + 1.
  std::span<const Strand> links() const { return links_; }
  /// Where the robot is, metres.
  Point robot() const { return nodes_.back().point; }
  /// The length that link i has when it is pulled, metres.
  double RestLength(std::size_t link) const { return link == 0 ? first_link_m_ : options_.link_length_m; }
  /// How much cable lies on the floor, slack included, metres.
  double paid_out_m() const;
  /// How much of that the links do not use: what their nodes are nearer than the links are long, metres. O(nodes).
  double SlackM() const;
  /// How it was made.
  const CableOptions& options() const { return options_; }
  /// The sum of all dt_s of steps that were not refused, seconds.
  double time_s() const { return time_s_; }
  /// Every touch so far, in the order in which they began.
  std::span<const Contact> contacts() const { return contacts_; }

  /// Nodes, and the corners that hold links, from base to robot.
  Polyline Shape() const;

  /// The chain as a walk from base to robot: its class, for all that the engine does with walks. O(size of it).
  Walk ClassWalk() const;

  /// The length of the chain pulled tight in its class: what the robot needs where it stands. O(size of ClassWalk).
  double TautLength() const { return PullTaut(space_->mesh(), ClassWalk()).length; }

 private:
  Cable(const TautSpace& space, Place base, const CableOptions& options);

  // Making and moving: cable.cc.
  void EndLinkAt(const Walk& walk);
  bool IsUnused() const { return nodes_.size() == 2 && links_[0].sleeve.size() == 1 && nodes_[0].point == robot(); }
  std::optional<Walk> WayTo(Point to) const;
  void Drive(const Walk& way, const std::optional<Strand>& taut);
  bool MayEmptyReel(double pull_m) const;
  Strand TautStrand(const Walk& walk) const { return StrandOf(walk, PullTaut(space_->mesh(), walk)); }

  // Pulling: cable_pull.cc.
  double PullFromRobot();
  double PullFromBase();
  void PayOut(double length_m);
  void SplitFirstLink();
  void DropPulledIn();
  void Relax(double excess_m, const Strand& taut);
  void LayTaut(const Strand& taut);
  void SpreadFromBase(double excess_m);
  void BlendWith(const Strand& taut);
  void SlideNode(std::size_t node, Place target, double by_m, Strand& way);
  void CutAt(const Strand& taut, std::span<const double> at_m);

  // Touching: cable_contacts.cc.
  void FindContacts(StepResult& result);
  void FindRobotContact(StepResult& result);
  std::optional<Point> UnderRobot() const;

  const TautSpace* space_;
  CableOptions options_;
  std::vector<Place> nodes_;
  std::vector<Strand> links_;
  double first_link_m_ = 0;
  double time_s_ = 0;
  std::vector<Contact> contacts_;
  std::vector<VertexId> held_;  ///< The corners that hold the cable, ascending, each once.
  bool on_cable_ = false;       ///< The robot stands on its cable.
};

}  // namespace tautline

#endif  // TAUTLINE_CABLE_CABLE_H_
