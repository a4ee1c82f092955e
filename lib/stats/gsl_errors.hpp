// GSL ends the process on an error unless told otherwise. Here its functions return nan or the limit of their range instead.
#pragma once

namespace slidezone {

/// To be called before the first use of GSL in a function; cheap, and the same for all threads.
void keep_gsl_from_aborting();

}  // namespace slidezone
