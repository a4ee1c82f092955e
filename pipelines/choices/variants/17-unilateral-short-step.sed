s/^contact = .*/contact = "unilateral"/
